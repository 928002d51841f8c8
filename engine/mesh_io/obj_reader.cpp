// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>

#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {
namespace {

/// Statements of OBJ that say nothing about a polygon mesh. Others are refused: a misspelt "v"
/// would shift every index after it.
constexpr std::array ignored = {"vt",        "vn",    "vp",    "p",        "l",        "g",
                                "o",         "s",     "mg",    "usemtl",   "mtllib",   "usemap",
                                "maplib",    "bevel", "lod",   "c_interp", "d_interp", "shadow_obj",
                                "trace_obj", "ctech", "stech", "cstype",   "deg",      "step",
                                "bmat",      "curv",  "curv2", "surf",     "parm",     "trim",
                                "hole",      "scrv",  "sp",    "end",      "con",      "call",
                                "csh",       "bsp",   "bzp",   "cdc",      "cdp",      "res"};

/// What a face may refer to further down in the file; checked at the end.
struct Furthest {
  std::int64_t index = 0;
  std::size_t line = 0;
};

/// One corner, "v", "v/vt", "v//vn" or "v/vt/vn": the vertex, from 1.
std::int64_t read_corner(MeshScanner& scan, std::string_view word, std::size_t vertices) {
  const std::string_view vertex = word.substr(0, word.find('/'));
  const std::string_view rest = word.substr(vertex.size());
  if (vertex.empty() || rest.find_first_not_of("/-+0123456789") != rest.npos ||
      std::ranges::count(rest, '/') > 2)
    scan.refuse(shown(word) + " is not a corner of a face");
  const std::int64_t index = scan.integer(vertex, "a vertex index");
  if (index == 0) scan.refuse("vertex index 0: the vertices of OBJ count from 1");
  if (index > 0) return index;
  const auto known = static_cast<std::int64_t>(vertices);
  if (index < -known)
    scan.refuse("vertex index " + std::to_string(index) + " is out of range: there are " +
                std::to_string(known) + " vertices so far");
  return known + 1 + index;
}

Polygon read_face(MeshScanner& scan, std::size_t vertices, Furthest& furthest) {
  Polygon face;
  for (std::string_view word = scan.word(); !word.empty(); word = scan.word()) {
    const std::int64_t index = read_corner(scan, word, vertices);
    if (index > furthest.index) furthest = {index, scan.line()};
    face.push_back(static_cast<std::size_t>(index - 1));
  }
  if (face.size() < 3) scan.refuse("a face with fewer than three corners");
  return face;
}

}  // namespace

PolygonSoup read_obj(const std::string& file, std::string_view bytes, const Progress& progress) {
  MeshScanner scan(file, bytes, '#', true, progress);
  PolygonSoup out;
  Furthest furthest;
  while (scan.next_line()) {
    const std::string_view keyword = scan.word();
    if (keyword == "v")
      out.points.push_back(scan.point());
    else if (keyword == "f" || keyword == "fo")
      out.polygons.push_back(read_face(scan, out.points.size(), furthest));
    else if (std::ranges::find(ignored, keyword) == ignored.end())
      scan.refuse("unknown statement " + shown(keyword));
  }
  if (furthest.index > static_cast<std::int64_t>(out.points.size()))
    scan.refuse_at(furthest.line, "vertex index " + std::to_string(furthest.index) +
                                      " is out of range: the file has " +
                                      std::to_string(out.points.size()) + " vertices");
  if (out.points.size() > std::numeric_limits<std::int32_t>::max())
    throw InputError::in(file, "more than 2^31 vertices");
  if (out.points.empty()) throw InputError::in(file, "the mesh has no vertices");
  if (out.polygons.empty()) throw InputError::in(file, "the mesh has no faces");
  return out;
}

}  // namespace sonde
