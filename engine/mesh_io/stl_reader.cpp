// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "engine/base/progress.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {
namespace {

/// The corners of triangles as points, one for each place, in the order of their first use.
PolygonSoup join_corners(const std::vector<Vec3>& corners, const Progress& progress) {
  std::vector<std::uint32_t> index = weld(corners, part_of(progress, 0, 0.6));
  std::size_t count = 0;
  for (std::size_t i = 0; i < index.size(); ++i) count += index[i] == i;
  PolygonSoup soup;
  soup.points.reserve(count);
  soup.polygons.reserve(corners.size() / 3);
  for_each_index(corners.size() / 3, part_of(progress, 0.6, 1), [&](std::size_t triangle) {
    std::uint32_t* const own = &index[3 * triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = 3 * triangle + k;
      if (own[k] != i) {
        own[k] = index[own[k]];
        continue;
      }
      own[k] = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back(corners[i]);
    }
    soup.polygons.push_back({own[0], own[1], own[2]});
  });
  return soup;
}

// ---------------------------------------------------------------------------------------- binary

constexpr std::size_t stl_header = 84, stl_record = 50;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// The number of triangles a binary STL file of these bytes declares.
std::optional<std::uint64_t> declared_triangles(std::string_view bytes) {
  if (bytes.size() < stl_header) return {};
  return little_endian(bytes, 80);
}

/// Both kinds may start with "solid": a file of just the size that its count asks for is binary.
bool is_binary_stl(std::string_view bytes) {
  const auto n = declared_triangles(bytes);
  return n && bytes.size() == stl_header + *n * stl_record;
}

/// One coordinate of a record: 0, 1 and 2 are those of the first corner.
double stored_coordinate(const std::string& file, std::string_view bytes, std::size_t record,
                         std::size_t number) {
  const std::size_t at = stl_header + record * stl_record + 12 + 4 * number;  // after the normal
  const double x = std::bit_cast<float>(little_endian(bytes, at));
  if (!std::isfinite(x))
    throw InputError::at_byte(file, at,
                              "a coordinate of triangle " + std::to_string(record + 1) + " of " +
                                  std::to_string(*declared_triangles(bytes)) + " is not finite");
  return x;
}

PolygonSoup read_binary_stl(const std::string& file, std::string_view bytes,
                            const Progress& progress) {
  const std::uint64_t triangles = *declared_triangles(bytes);
  if (triangles == 0) throw InputError::in(file, "the mesh has no triangles");
  std::vector<Vec3> corners(3 * triangles);
  for_each_index(triangles, part_of(progress, 0, 0.3), [&](std::size_t i) {
    for (std::size_t k = 0; k < 9; ++k)
      corners[3 * i + k / 3][static_cast<Eigen::Index>(k % 3)] =
          stored_coordinate(file, bytes, i, k);
  });
  return join_corners(corners, part_of(progress, 0.3, 1));
}

[[noreturn]] void refuse_stl(const std::string& file, std::string_view bytes) {
  const auto n = declared_triangles(bytes);
  if (!n) throw InputError::in(file, "too short for an STL file");
  throw InputError::at_byte(file, 80,
                            "the header declares " + std::to_string(*n) + " triangles, that is " +
                                std::to_string(stl_header + *n * stl_record) +
                                " bytes, but the file has " + std::to_string(bytes.size()));
}

// ------------------------------------------------------------------------------------------ text

/// "solid" alone does not tell, but text has no zero bytes.
bool looks_like_text_stl(std::string_view text) {
  if (text.substr(0, 1024).find('\0') != text.npos) return false;
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == text.npos) return false;
  std::string word(text.substr(start, 5));
  for (char& c : word) c = static_cast<char>(c | 0x20);
  return word == "solid";
}

bool same_word(std::string_view a, std::string_view lower) {
  return std::ranges::equal(
      a, lower, [](char x, char y) { return (x >= 'A' && x <= 'Z' ? x - 'A' + 'a' : x) == y; });
}

/// Goes to the next line, which must start with the keyword.
void expect(MeshScanner& scan, std::string_view keyword) {
  const std::string expected = shown(keyword) + " is expected";
  if (!scan.next_line()) scan.refuse(expected + ", but the file ends");
  const std::string_view word = scan.word();
  if (!same_word(word, keyword)) scan.refuse(expected + ", not " + shown(word));
}

void end_of_line(MeshScanner& scan) {
  const std::string_view word = scan.word();
  if (!word.empty()) scan.refuse("unexpected " + shown(word));
}

/// The rest of a facet; its normal is not looked at: that of a sliver may well be no number.
void read_facet(MeshScanner& scan, std::vector<Vec3>& corners) {
  if (!same_word(scan.word(), "normal") || scan.skip_words() != 3)
    scan.refuse("\"facet normal\" and three numbers are expected");
  expect(scan, "outer");
  if (!same_word(scan.word(), "loop")) scan.refuse("\"outer loop\" is expected");
  for (int corner = 0; corner < 3; ++corner) {
    expect(scan, "vertex");
    corners.push_back(scan.point());
    end_of_line(scan);
  }
  expect(scan, "endloop");
  expect(scan, "endfacet");
}

PolygonSoup read_text_stl(const std::string& file, std::string_view text,
                          const Progress& progress) {
  const Progress walking = part_of(progress, 0, 0.6);
  MeshScanner scan(file, text, '\0', false, walking);
  std::vector<Vec3> corners;
  bool inside = false;  // of a solid; a file may hold several, one after the other
  while (scan.next_line()) {
    const std::string_view word = scan.word();
    if (!inside && same_word(word, "solid")) {
      inside = true;
    } else if (inside && same_word(word, "facet")) {
      read_facet(scan, corners);
    } else if (inside && same_word(word, "endsolid")) {
      inside = false;
    } else {
      scan.refuse(inside ? "\"facet\" or \"endsolid\" is expected, not " + shown(word)
                         : "data outside of a solid: " + shown(word));
    }
  }
  if (inside) scan.refuse("the file ends before \"endsolid\"");
  if (corners.empty()) throw InputError::in(file, "the mesh has no triangles");
  return join_corners(corners, part_of(progress, 0.6, 1));
}

}  // namespace

PolygonSoup read_stl(const std::string& file, std::string_view bytes, const Progress& progress) {
  if (is_binary_stl(bytes)) return read_binary_stl(file, bytes, progress);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  std::string_view text = bytes;
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  if (!looks_like_text_stl(text)) refuse_stl(file, bytes);
  return read_text_stl(file, text, progress);
}

}  // namespace sonde
