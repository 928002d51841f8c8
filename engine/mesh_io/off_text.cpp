// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>

#include "engine/mesh_io/off_parts.hpp"

namespace sonde {
namespace {

/// Texture, normal and colour are nine numbers; some programs write all that they have.
constexpr std::size_t most_extras = 9;

/// Non-blank lines that follow, up to `enough`.
std::uint64_t lines_left(MeshScanner scan, std::uint64_t enough) {
  std::uint64_t n = 0;
  while (n < enough && scan.next_line()) ++n;
  return n;
}

class OffText {
 public:
  OffText(MeshScanner scan, const OffCounts& counts, std::size_t announced)
      : scan_(scan), counts_(counts), announced_(announced) {}

  PolygonSoup read() {
    out_.points.reserve(counts_.vertices);
    out_.polygons.reserve(counts_.faces);
    const bool by_line = is_vertex_a_line();
    if (by_line)
      read_lines_of_vertices();
    else
      read_vertices_anywhere();
    if (by_line || (!a_number_a_line_ && !scan_.has_word() &&
                    lines_left(scan_, counts_.faces) >= counts_.faces))
      read_lines_of_faces();
    else
      read_faces_anywhere();
    if (scan_.has_word() || scan_.next_line())
      scan_.refuse("data after the last of the " + std::to_string(counts_.faces) +
                   " declared faces");
    if (out_.polygons.empty())
      scan_.refuse_at(thin_.tally.first, "no face has more than two corners");
    remark(out_.remarks, "line", thin_);
    scan_.remark_to(out_.remarks);
    return std::move(out_);
  }

 private:
  /// Sets how many numbers a vertex has after its coordinates.
  bool is_vertex_a_line() {
    if (scan_.has_word()) return false;  // all goes on in the line of the counts
    MeshScanner ahead = scan_;
    if (!ahead.next_line()) return true;
    const std::size_t words = ahead.skip_words(), least = 3 + announced_;
    extras_ = words < 3 ? 0 : words - 3;
    if (words == least) return true;
    a_number_a_line_ = words == 1;
    if (a_number_a_line_) return false;
    const bool several = words < 3 || words >= 2 * least;
    const std::uint64_t all = counts_.vertices + counts_.faces;
    if (several && lines_left(scan_, all) < all) return false;
    if (words >= 3) accept_extras(ahead.line());
    return true;
  }

  void accept_extras(std::size_t line) {
    if (extras_ > most_extras || (announced_ == 0 && extras_ == 1))
      scan_.refuse_at(line, "three coordinates expected, but the line has more");
    out_.remarks.push_back("line " + std::to_string(line) + ": the vertices have " +
                           std::to_string(extras_) + " numbers after their coordinates, not the " +
                           std::to_string(announced_) + " that the keyword announces");
  }

  void need_line(std::uint64_t done, std::uint64_t declared, const char* what) {
    if (!scan_.next_line())
      scan_.refuse("the file ends after " + std::to_string(done) + " of " +
                   std::to_string(declared) + " declared " + what);
  }
  void need_word(std::uint64_t done, std::uint64_t declared, const char* what) {
    while (!scan_.has_word()) need_line(done, declared, what);
  }

  void read_lines_of_vertices() {
    for (std::uint64_t i = 0; i < counts_.vertices; ++i) {
      need_line(i, counts_.vertices, "vertices");
      out_.points.push_back(scan_.point());
      const std::size_t more = scan_.has_word() ? scan_.skip_words() : 0;
      if (more == extras_) continue;
      if (extras_ == 0) scan_.refuse("three coordinates expected, but the line has more");
      scan_.refuse(std::to_string(more) +
                   " numbers after the coordinates, where the first vertex "
                   "has " +
                   std::to_string(extras_));
    }
  }

  void read_vertices_anywhere() {
    for (std::uint64_t i = 0; i < counts_.vertices; ++i) {
      Vec3 x;
      for (double& c : x) {
        need_word(i, counts_.vertices, "vertices");
        c = scan_.coordinate();
      }
      for (std::size_t k = 0; k < announced_; ++k) {
        need_word(i, counts_.vertices, "vertices");
        scan_.check_number();
      }
      out_.points.push_back(x);
    }
  }

  void read_lines_of_faces() {
    for (std::uint64_t i = 0; i < counts_.faces; ++i) {
      need_line(i, counts_.faces, "faces");
      const std::uint64_t corners = scan_.count("a number of corners");
      Polygon face;
      face.reserve(std::min<std::uint64_t>(corners, scan_.bytes_in_line()));
      for (std::uint64_t k = 0; k < corners; ++k) face.push_back(scan_.index(counts_.vertices));
      if (scan_.skip_words() > 4) scan_.refuse("more numbers than the corners and a colour");
      take(std::move(face));
    }
  }

  void read_faces_anywhere() {
    for (std::uint64_t i = 0; i < counts_.faces; ++i) {
      need_word(i, counts_.faces, "faces");
      const std::uint64_t corners = scan_.count("a number of corners");
      Polygon face;
      for (std::uint64_t k = 0; k < corners; ++k) {
        need_word(i, counts_.faces, "faces");
        face.push_back(scan_.index(counts_.vertices));
      }
      take(std::move(face));
    }
  }

  void take(Polygon face) {
    if (face.size() < 3) return thin_.add(scan_.line(), face.size());
    out_.polygons.push_back(std::move(face));
  }

  MeshScanner scan_;
  OffCounts counts_;
  std::size_t announced_;
  std::size_t extras_ = 0;
  bool a_number_a_line_ = false;
  PolygonSoup out_;
  ThinFaces thin_;
};

OffCounts read_counts(MeshScanner& scan, std::string_view first) {
  const std::int64_t vertices = scan.integer(first, "a number of vertices");
  if (vertices < 0) scan.refuse(shown(first) + " is not a number of vertices");
  if (!scan.has_word()) scan.next_line();
  return {static_cast<std::uint64_t>(vertices), scan.count("a number of faces")};
}

/// The number of edges is often wrong or left out, and says nothing. It may stand on a line of its
/// own.
void pass_edges(MeshScanner& scan) {
  if (scan.has_word()) {
    MeshScanner ahead = scan;
    if (ahead.word().find_first_of(".eE") == std::string_view::npos) scan.word();
    return;
  }
  MeshScanner ahead = scan;
  if (!ahead.next_line() || ahead.skip_words() != 1) return;
  scan.next_line();
  scan.word();
}

}  // namespace

PolygonSoup read_text_off(MeshScanner& scan, std::string_view first, std::size_t extras) {
  const OffCounts counts = read_counts(scan, first);
  const MeshScanner before_edges = scan;
  pass_edges(scan);
  constexpr std::uint64_t least_vertex = 6, least_face = 4;  // "0 0 0\n", "1 0\n"
  const std::string fault =
      fault_of(counts, scan.bytes_left() + (scan.has_word() ? scan.bytes_in_line() : 0),
               least_vertex, least_face);
  if (!fault.empty()) scan.refuse(fault);
  if (!scan.has_word()) return OffText(scan, counts, extras).read();
  // All in one line: whether that number is one of edges is told by what the rest then is.
  const auto read_from = [&](const MeshScanner& start) -> std::optional<PolygonSoup> {
    try {
      return OffText(start, counts, extras).read();
    } catch (const InputError&) {
      return std::nullopt;
    }
  };
  std::optional<PolygonSoup> with = read_from(scan), without = read_from(before_edges);
  if (without && (!with || without->remarks.size() < with->remarks.size())) return *without;
  if (with) return *with;
  return OffText(scan, counts, extras).read();  // says what is wrong
}

}  // namespace sonde
