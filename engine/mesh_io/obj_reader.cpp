// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>

#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/mesh_scan.hpp"
#include "engine/mesh_io/plain_text.hpp"

namespace sonde {
namespace {

/// Statements of OBJ that say nothing about a polygon mesh.
constexpr std::array passed_over = {
    "vt",     "vn",       "vp",       "p",          "l",         "g",      "o",
    "s",      "mg",       "usemtl",   "mtllib",     "usemap",    "maplib", "bevel",
    "lod",    "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech",  "stech",
    "cstype", "deg",      "step",     "bmat",       "curv",      "curv2",  "parm",
    "trim",   "hole",     "scrv",     "sp",         "end",       "con"};
/// Those of free-form surfaces: shape that is not read.
constexpr std::array surfaces = {"surf", "bsp", "bzp", "cdc", "cdp", "res"};
/// Those that run other files or programs.
constexpr std::array calls = {"call", "csh"};

/// What a face may refer to further down in the file; checked at the end.
struct Furthest {
  std::int64_t index = 0;
  std::size_t line = 0;
};

/// A statement of some program's own (a material's "Kd", "tex"). What begins as a vertex or a face
/// does may be a misspelt one, which would shift every index after it or leave a hole; and what is
/// no word is no statement.
bool may_be_passed_over(std::string_view keyword) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_of_word = [&](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.' || c == ':';
  };
  return is_letter(keyword[0]) && std::string_view("vVfF").find(keyword[0]) == keyword.npos &&
         std::ranges::all_of(keyword, is_of_word);
}

class ObjReader {
 public:
  ObjReader(const std::string& file, std::string_view bytes, const Progress& progress)
      : file_(file), scan_(file, bytes, '#', true, progress) {
    scan_.drop_end_marks();
  }

  PolygonSoup read() {
    while (scan_.next_line()) {
      const std::string_view keyword = scan_.word();
      if (keyword == "v")
        read_vertex();
      else if (keyword == "f" || keyword == "fo")
        read_face();
      else
        read_other(keyword);
    }
    check();
    say();
    return std::move(out_);
  }

 private:
  /// A colour may follow, or a weight, which bears on free-form curves alone.
  void read_vertex() {
    out_.points.push_back(scan_.point());
    if (!scan_.has_word()) return;
    const std::string_view weight = scan_.word();
    if (!scan_.has_word() && number(weight) != 1) weights_.add(scan_.line());
  }

  /// One corner, "v", "v/vt", "v//vn" or "v/vt/vn": the vertex, from 1.
  std::int64_t read_corner(std::string_view word) {
    const std::string_view vertex = word.substr(0, word.find('/'));
    const std::string_view rest = word.substr(vertex.size());
    if (vertex.empty() || rest.find_first_not_of("/-+.0123456789") != rest.npos ||
        std::ranges::count(rest, '/') > 2)
      scan_.refuse(shown(word) + " is not a corner of a face");
    const std::int64_t index = scan_.integer(vertex, "a vertex index");
    if (index == 0) scan_.refuse("vertex index 0: the vertices of OBJ count from 1");
    if (index > 0) return index;
    const auto known = static_cast<std::int64_t>(out_.points.size());
    if (index < -known)
      scan_.refuse("vertex index " + std::to_string(index) + " is out of range: there are " +
                   std::to_string(known) + " vertices so far");
    return known + 1 + index;
  }

  void read_face() {
    Polygon face;
    for (std::string_view word = scan_.word(); !word.empty(); word = scan_.word()) {
      const std::int64_t index = read_corner(word);
      if (index > furthest_.index) furthest_ = {index, scan_.line()};
      face.push_back(static_cast<std::size_t>(index - 1));
    }
    if (face.empty()) scan_.refuse("a face without corners");
    if (face.size() < 3) return thin_.add(scan_.line(), face.size());
    out_.polygons.push_back(std::move(face));
  }

  void read_other(std::string_view keyword) {
    const auto is_in = [keyword](const auto& list) {
      return std::ranges::find(list, keyword) != list.end();
    };
    if (is_in(passed_over)) return;
    if (is_in(surfaces)) return surfaces_.add(scan_.line());
    if (is_in(calls)) return calls_.add(scan_.line());
    if (!may_be_passed_over(keyword)) scan_.refuse("unknown statement " + shown(keyword));
    if (unknown_.count == 0) first_unknown_ = keyword;
    unknown_.add(scan_.line());
  }

  void check() const {
    const std::size_t vertices = out_.points.size();
    if (furthest_.index > static_cast<std::int64_t>(vertices))
      scan_.refuse_at(furthest_.line, "vertex index " + std::to_string(furthest_.index) +
                                          " is out of range: the file has " +
                                          std::to_string(vertices) + " vertices");
    if (vertices > std::numeric_limits<std::int32_t>::max())
      throw InputError::in(file_, "more than 2^31 vertices");
    if (vertices == 0) throw InputError::in(file_, "the mesh has no vertices");
    if (!out_.polygons.empty()) return;
    if (surfaces_.count > 0)
      scan_.refuse_at(surfaces_.first,
                      "a free-form surface: Sonde reads polygons, and none is here");
    if (thin_.tally.count > 0)
      scan_.refuse_at(thin_.tally.first, "no face has more than two corners");
    throw InputError::in(file_, "the mesh has no faces");
  }

  void say() {
    remark(out_.remarks, "line", thin_);
    remark(out_.remarks, "line", surfaces_, "statement of free-form surfaces is not read",
           "statements of free-form surfaces are not read");
    remark(out_.remarks, "line", calls_, "statement that runs another file is not followed",
           "statements that run other files are not followed");
    remark(out_.remarks, "line", weights_, "weight of a vertex is not used",
           "weights of vertices are not used");
    const std::string first = "of no OBJ passed over: " + shown(first_unknown_);
    remark(out_.remarks, "line", unknown_, ("statement " + first).c_str(),
           ("statements " + first + " first").c_str());
    scan_.remark_to(out_.remarks);
  }

  const std::string& file_;
  MeshScanner scan_;
  PolygonSoup out_;
  Furthest furthest_;
  ThinFaces thin_;
  Tally surfaces_, calls_, weights_, unknown_;
  std::string_view first_unknown_;
};

}  // namespace

PolygonSoup read_obj(const std::string& file, std::string_view bytes, const Progress& progress) {
  return ObjReader(file, plain_text(file, bytes), progress).read();
}

}  // namespace sonde
