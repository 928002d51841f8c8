// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "engine/mesh_io/binary_scan.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {
namespace {

bool drop_prefix(std::string_view& word, std::string_view prefix) {
  const bool has = word.starts_with(prefix);
  if (has) word.remove_prefix(prefix.size());
  return has;
}

/// What a vertex has after its three coordinates, in numbers.
constexpr std::size_t normal_numbers = 3, colour_numbers = 4, texture_numbers = 2;

/// Reads "OFF" with its prefixes; returns how many numbers a vertex has beside its coordinates.
std::size_t read_keyword(MeshScanner& scan) {
  const std::string_view keyword = scan.word();
  std::string_view rest = keyword;
  std::size_t extras = drop_prefix(rest, "ST") ? texture_numbers : 0;
  extras += drop_prefix(rest, "C") ? colour_numbers : 0;
  extras += drop_prefix(rest, "N") ? normal_numbers : 0;
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF" || rest.ends_with("SKEL"))
    scan.refuse("the " + std::string(keyword) + " variant of OFF is not supported");
  if (rest != "OFF") scan.refuse("not an OFF file: it starts with " + shown(keyword));
  return extras;
}

struct Counts {
  std::uint64_t vertices, faces;
};

/// "" where the counts can be; else why not. `room`: the bytes that follow, of which a vertex and a
/// face take so many at least.
std::string fault_of(const Counts& counts, std::uint64_t room, std::uint64_t least_vertex,
                     std::uint64_t least_face) {
  if (counts.vertices > room || counts.faces > room ||
      counts.vertices * least_vertex + counts.faces * least_face > room + 1)
    return "the header declares " + std::to_string(counts.vertices) + " vertices and " +
           std::to_string(counts.faces) + " faces, but only " + std::to_string(room) +
           " bytes follow";
  if (counts.vertices == 0) return "the mesh has no vertices";
  if (counts.faces == 0) return "the mesh has no faces";
  return {};
}

// ------------------------------------------------------------------------------------------ text

/// A number of edges may follow.
Counts read_counts(MeshScanner& scan, std::string_view first) {
  const std::int64_t vertices = scan.integer(first, "a number of vertices");
  if (vertices < 0) scan.refuse(shown(first) + " is not a number of vertices");
  const Counts counts{static_cast<std::uint64_t>(vertices), scan.count("a number of faces")};
  constexpr std::uint64_t least_vertex = 6, least_face = 4;  // "0 0 0\n", "1 0\n"
  const std::string fault = fault_of(counts, scan.bytes_left(), least_vertex, least_face);
  if (!fault.empty()) scan.refuse(fault);
  return counts;
}

void need_line(MeshScanner& scan, std::uint64_t done, std::uint64_t declared, const char* what) {
  if (!scan.next_line())
    scan.refuse("the file ends after " + std::to_string(done) + " of " + std::to_string(declared) +
                " declared " + what);
}

Polygon read_face(MeshScanner& scan, std::uint64_t vertices) {
  const std::uint64_t corners = scan.count("a number of corners");
  if (corners < 3) scan.refuse("a face with fewer than three corners");
  Polygon face;
  face.reserve(std::min<std::uint64_t>(corners, scan.bytes_in_line()));
  for (std::uint64_t k = 0; k < corners; ++k) face.push_back(scan.index(vertices));
  if (scan.skip_words() > 4) scan.refuse("more numbers than the corners and a colour");
  return face;
}

PolygonSoup read_text(MeshScanner& scan, const Counts& counts, bool extras) {
  PolygonSoup out;
  out.points.reserve(counts.vertices);
  for (std::uint64_t i = 0; i < counts.vertices; ++i) {
    need_line(scan, i, counts.vertices, "vertices");
    out.points.push_back(scan.point());
    const std::size_t more = scan.skip_words();
    if (more > 0 && !extras) scan.refuse("three coordinates expected, but the line has more");
  }
  out.polygons.reserve(counts.faces);
  for (std::uint64_t i = 0; i < counts.faces; ++i) {
    need_line(scan, i, counts.faces, "faces");
    out.polygons.push_back(read_face(scan, counts.vertices));
  }
  if (scan.next_line())
    scan.refuse("data after the last of the " + std::to_string(counts.faces) + " declared faces");
  return out;
}

// ---------------------------------------------------------------------------------------- binary

/// As Geomview writes it: whole numbers of four bytes and floats, the most significant byte first.
class BinaryOff {
 public:
  BinaryOff(BinaryScanner scan, std::size_t extras) : scan_(scan), extras_(extras) {}

  PolygonSoup read() {
    const std::size_t start = scan_.position();
    scan_.need(3 * word, [] { return std::string("the numbers of vertices and faces"); });
    const Counts counts{scan_.take<std::uint32_t>(), scan_.take<std::uint32_t>()};
    scan_.skip(word);  // of edges
    const std::string fault = fault_of(counts, scan_.bytes_left(), (3 + extras_) * word, 5 * word);
    if (!fault.empty()) scan_.refuse_at(start, fault);
    PolygonSoup out;
    out.points.reserve(counts.vertices);
    for (std::uint64_t i = 0; i < counts.vertices; ++i) out.points.push_back(point(i, counts));
    out.polygons.reserve(counts.faces);
    for (std::uint64_t i = 0; i < counts.faces; ++i) out.polygons.push_back(face(i, counts));
    if (scan_.bytes_left() > 0)
      scan_.refuse_at(scan_.position(),
                      std::to_string(scan_.bytes_left()) + " bytes more than the header declares");
    return out;
  }

 private:
  static constexpr std::uint64_t word = 4;  // bytes

  static std::string name(const char* what, std::uint64_t i, std::uint64_t of) {
    return std::string(what) + " " + std::to_string(i + 1) + " of " + std::to_string(of);
  }

  Vec3 point(std::uint64_t i, const Counts& counts) {
    scan_.report(i);
    scan_.need((3 + extras_) * word, [&] { return name("vertex", i, counts.vertices); });
    Vec3 x;
    for (double& c : x) {
      c = static_cast<double>(scan_.take<float>());
      if (!std::isfinite(c))
        scan_.refuse_at(scan_.position() - word,
                        "a coordinate of " + name("vertex", i, counts.vertices) + " is not finite");
    }
    scan_.skip(extras_ * word);
    return x;
  }

  Polygon face(std::uint64_t i, const Counts& counts) {
    scan_.report(i);
    const auto own_name = [&] { return name("face", i, counts.faces); };
    scan_.need(word, own_name);
    const std::uint64_t corners = scan_.take<std::uint32_t>();
    if (corners < 3)
      scan_.refuse_at(scan_.position() - word, own_name() + " has fewer than three corners");
    scan_.need((corners + 1) * word, own_name);
    Polygon out(corners);
    for (std::size_t& corner : out) {
      corner = scan_.take<std::uint32_t>();
      if (corner >= counts.vertices)
        scan_.refuse_at(scan_.position() - word, "vertex index " + std::to_string(corner) + " in " +
                                                     own_name() + " is out of range (0 to " +
                                                     std::to_string(counts.vertices - 1) + ")");
    }
    const std::uint64_t colours = scan_.take<std::uint32_t>();
    scan_.need(colours * word, own_name);
    scan_.skip(colours * word);
    return out;
  }

  BinaryScanner scan_;
  std::size_t extras_;
};

}  // namespace

PolygonSoup read_off(const std::string& file, std::string_view bytes, const Progress& progress) {
  MeshScanner scan(file, bytes, '#', false, progress);
  if (!scan.next_line()) throw InputError::in(file, "the file holds nothing but comments");
  const std::size_t extras = read_keyword(scan);
  std::string_view first = scan.word();
  if (first == "BINARY") {
    const BinaryScanner binary(file, bytes, scan.position(), std::endian::big, progress);
    return BinaryOff(binary, extras).read();
  }
  // The counts stand on the line of the keyword or on the next.
  if (first.empty()) {
    if (!scan.next_line()) scan.refuse("the file ends before the number of vertices");
    first = scan.word();
  }
  const Counts counts = read_counts(scan, first);
  return read_text(scan, counts, extras > 0);
}

}  // namespace sonde
