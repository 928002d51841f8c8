// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/mesh_checks.hpp"
#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {
namespace {

bool drop_prefix(std::string_view& word, std::string_view prefix) {
  const bool has = word.starts_with(prefix);
  if (has) word.remove_prefix(prefix.size());
  return has;
}

/// Reads "OFF" with its prefixes; true where a vertex line has more than coordinates.
bool read_keyword(MeshScanner& scan) {
  const std::string_view keyword = scan.word();
  std::string_view rest = keyword;
  bool extras = drop_prefix(rest, "ST");
  extras |= drop_prefix(rest, "C");
  extras |= drop_prefix(rest, "N");
  if (rest == "4OFF" || rest == "nOFF" || rest == "4nOFF" || rest.ends_with("SKEL"))
    scan.refuse("the " + std::string(keyword) + " variant of OFF is not supported");
  if (rest != "OFF") scan.refuse("not an OFF file: it starts with " + shown(keyword));
  return extras;
}

struct Counts {
  std::uint64_t vertices, faces;
};

/// The counts stand on the line of the keyword or on the next; a number of edges may follow.
Counts read_counts(MeshScanner& scan) {
  std::string_view first = scan.word();
  if (first.empty()) {
    if (!scan.next_line()) scan.refuse("the file ends before the number of vertices");
    first = scan.word();
  }
  if (first == "BINARY") scan.refuse("a binary OFF whose first line is not \"OFF BINARY\"");
  const std::int64_t vertices = scan.integer(first, "a number of vertices");
  if (vertices < 0) scan.refuse(shown(first) + " is not a number of vertices");
  const Counts counts{static_cast<std::uint64_t>(vertices), scan.count("a number of faces")};
  const std::uint64_t room = scan.bytes_left();
  constexpr std::uint64_t least_vertex = 6, least_face = 4;  // "0 0 0\n", "1 0\n"
  if (counts.vertices > room || counts.faces > room ||
      counts.vertices * least_vertex + counts.faces * least_face > room + 1)
    scan.refuse("the header declares " + std::to_string(counts.vertices) + " vertices and " +
                std::to_string(counts.faces) + " faces, but only " + std::to_string(room) +
                " bytes follow");
  if (counts.vertices == 0 || counts.faces == 0)
    scan.refuse(counts.vertices == 0 ? "the mesh has no vertices" : "the mesh has no faces");
  return counts;
}

void need_line(MeshScanner& scan, std::uint64_t done, std::uint64_t declared, const char* what) {
  if (!scan.next_line())
    scan.refuse("the file ends after " + std::to_string(done) + " of " + std::to_string(declared) +
                " declared " + what);
}

void check_face(MeshScanner& scan, std::uint64_t vertices, std::string& out) {
  const std::uint64_t corners = scan.count("a number of corners");
  if (corners < 3) scan.refuse("a face with fewer than three corners");
  out += std::to_string(corners);
  for (std::uint64_t k = 0; k < corners; ++k) {
    out += ' ';
    out += std::to_string(scan.index(vertices));
  }
  out += '\n';
  if (scan.skip_words() > 4) scan.refuse("more numbers than the corners and a colour");
}

}  // namespace

CheckedMesh check_off(const std::string& file, std::string_view text, const Progress& progress) {
  MeshScanner scan(file, text, '#', false, progress);
  if (!scan.next_line()) throw InputError::in(file, "the file holds nothing but comments");
  const bool extras = read_keyword(scan);
  const Counts counts = read_counts(scan);
  CheckedMesh out;
  out.points = counts.vertices;
  out.polygons = counts.faces;
  out.text.reserve(text.size() + 64);
  out.text =
      "OFF\n" + std::to_string(counts.vertices) + " " + std::to_string(counts.faces) + " 0\n";
  for (std::uint64_t i = 0; i < counts.vertices; ++i) {
    need_line(scan, i, counts.vertices, "vertices");
    for (int k = 0; k < 3; ++k) scan.copy_coordinate(out.text);
    out.text += '\n';
    const std::size_t more = scan.skip_words();
    if (more > 0 && !extras) scan.refuse("three coordinates expected, but the line has more");
  }
  for (std::uint64_t i = 0; i < counts.faces; ++i) {
    need_line(scan, i, counts.faces, "faces");
    check_face(scan, counts.vertices, out.text);
  }
  if (scan.next_line())
    scan.refuse("data after the last of the " + std::to_string(counts.faces) + " declared faces");
  return out;
}

}  // namespace sonde
