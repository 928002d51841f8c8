// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/off_parts.hpp"
#include "engine/mesh_io/plain_text.hpp"

namespace sonde {

std::string fault_of(const OffCounts& counts, std::uint64_t room, std::uint64_t least_vertex,
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

namespace {

/// What the keyword says.
struct OffKeyword {
  bool is_there = true;
  std::size_t extras = 0;  ///< numbers that a vertex has beside its coordinates
};

struct OffAttribute {
  std::string_view prefix;
  std::size_t numbers;  ///< of each vertex
};
constexpr OffAttribute off_attributes[] = {{"ST", 2}, {"C", 4}, {"N", 3}};

/// "OFF" with prefixes: Geomview has ST, C and N in this order, MeshLab and others in any.
bool parse_keyword(std::string_view word, OffKeyword& keyword) {
  bool seen[std::size(off_attributes)] = {};
  while (word != "OFF") {
    bool found = false;
    for (std::size_t k = 0; k < std::size(off_attributes) && !found; ++k) {
      const OffAttribute& attribute = off_attributes[k];
      found = !seen[k] && word.starts_with(attribute.prefix);
      if (!found) continue;
      seen[k] = true;
      word.remove_prefix(attribute.prefix.size());
      keyword.extras += attribute.numbers;
    }
    if (!found) return false;
  }
  return true;
}

std::string in_capitals(std::string_view word) {
  std::string out(word);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

/// The first word. Geomview lets the keyword be left out: a file may begin with its counts.
OffKeyword read_keyword(MeshScanner& scan, std::string_view word, Remarks& remarks) {
  const std::string at = "line " + std::to_string(scan.line());
  if (word.find_first_not_of("0123456789") == word.npos) {
    remarks.push_back(at + ": no keyword, read as \"OFF\"");
    return {false, 0};
  }
  // In these the case counts: "nOFF" has points of n dimensions, "NOFF" has normals.
  if (word == "4OFF" || word == "nOFF" || word == "4nOFF" || word.ends_with("SKEL"))
    scan.refuse("the " + std::string(word) + " variant of OFF is not supported");
  OffKeyword keyword;
  if (parse_keyword(word, keyword)) return keyword;
  keyword = {};
  const std::string capitals = in_capitals(word.substr(0, 8));
  if (word.size() > capitals.size() || !parse_keyword(capitals, keyword))
    scan.refuse("not an OFF file: it starts with " + shown(word));
  remarks.push_back(at + ": the keyword " + shown(word) + " is read as \"" + capitals + "\"");
  return keyword;
}

}  // namespace

PolygonSoup read_off(const std::string& file, std::string_view bytes, const Progress& progress) {
  bytes = plain_text(file, bytes);
  MeshScanner scan(file, bytes, '#', false, progress);
  if (!scan.next_line()) throw InputError::in(file, "the file holds nothing but comments");
  std::string_view word = scan.word();
  Remarks remarks;
  const OffKeyword keyword = read_keyword(scan, word, remarks);
  if (keyword.is_there) word = scan.word();
  PolygonSoup out;
  if (keyword.is_there && word == "BINARY") {
    const BinaryScanner binary(file, bytes, scan.position(), std::endian::big, progress);
    out = read_binary_off(binary, keyword.extras);
  } else {
    scan.drop_end_marks();
    // The counts stand on the line of the keyword or on the next.
    if (word.empty()) {
      if (!scan.next_line()) scan.refuse("the file ends before the number of vertices");
      word = scan.word();
    }
    out = read_text_off(scan, word, keyword.extras);
  }
  out.remarks.insert(out.remarks.begin(), remarks.begin(), remarks.end());
  return out;
}

}  // namespace sonde
