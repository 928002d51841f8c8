// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "engine/base/progress.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/plain_text.hpp"
#include "engine/mesh_io/remarks.hpp"
#include "engine/mesh_io/stl_parts.hpp"
#include "engine/text/printable.hpp"

namespace sonde {

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

namespace {

constexpr std::size_t stl_header = 84, stl_record = 50;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

/// What a file of these bytes holds if it is binary.
struct BinaryStl {
  std::uint64_t declared = 0;
  std::uint64_t triangles = 0;
  std::size_t left = 0;  ///< bytes after the last triangle

  /// Some programs write the number last, and leave 0 or all ones where they cannot: the size of
  /// the file tells it then.
  bool has_placeholder() const { return declared == 0 || declared == 0xffffffff; }
};

/// None where the bytes cannot be all that the count in the header declares. Whole records after
/// the last may be triangles that the count leaves out: a wrong count, unless they are all zeros.
std::optional<BinaryStl> binary_stl(std::string_view bytes) {
  if (bytes.size() < stl_header) return {};
  BinaryStl stl;
  stl.declared = little_endian(bytes, 80);
  const std::size_t room = bytes.size() - stl_header;
  stl.triangles = stl.has_placeholder() && room >= stl_record ? room / stl_record : stl.declared;
  if (stl.triangles > room / stl_record) return {};
  stl.left = room - stl.triangles * stl_record;
  const std::string_view rest = bytes.substr(bytes.size() - stl.left);
  const bool may_be_more = stl.has_placeholder() || stl.left % stl_record == 0;
  if (may_be_more && !is_padding(rest)) return {};
  return stl;
}

/// One coordinate of a record: 0, 1 and 2 are those of the first corner.
double stored_coordinate(const std::string& file, std::string_view bytes, const BinaryStl& stl,
                         std::size_t record, std::size_t number) {
  const std::size_t at = stl_header + record * stl_record + 12 + 4 * number;  // after the normal
  const double x = std::bit_cast<float>(little_endian(bytes, at));
  if (!std::isfinite(x))
    throw InputError::at_byte(file, at,
                              "a coordinate of triangle " + std::to_string(record + 1) + " of " +
                                  std::to_string(stl.triangles) + " is not finite");
  return x;
}

PolygonSoup read_binary_stl(const std::string& file, std::string_view bytes, const BinaryStl& stl,
                            const Progress& progress) {
  if (stl.triangles == 0) throw InputError::in(file, "the mesh has no triangles");
  std::vector<Vec3> corners(3 * stl.triangles);
  for_each_index(stl.triangles, part_of(progress, 0, 0.3), [&](std::size_t i) {
    for (std::size_t k = 0; k < 9; ++k)
      corners[3 * i + k / 3][static_cast<Eigen::Index>(k % 3)] =
          stored_coordinate(file, bytes, stl, i, k);
  });
  PolygonSoup soup = join_corners(corners, part_of(progress, 0.3, 1));
  if (stl.triangles != stl.declared)
    soup.remarks.push_back("byte 80: the header declares " + std::to_string(stl.declared) +
                           " triangles; by its size the file has " + std::to_string(stl.triangles));
  remark_on_bytes(soup.remarks, stl.left, "the last triangle");
  return soup;
}

/// The first bytes for a person: what a keyboard can type as it is, the others as \xNN.
std::string first_bytes(std::string_view bytes) {
  constexpr std::size_t enough = 8;
  return '"' + typeable(bytes.substr(0, enough)) + (bytes.size() > enough ? "…\"" : "\"");
}

/// Those that no text has.
bool has_controls(std::string_view bytes) {
  return std::ranges::any_of(bytes,
                             [](char c) { return (c >= 0 && c < '\t') || (c > '\r' && c < ' '); });
}

/// Text that a header of 80 bytes does not hold: the beginning of a web page or of a table, or
/// lines up to where a binary file has its count (then arithmetic on those letters says nothing).
bool is_other_text(std::string_view bytes) {
  const std::string_view start = bytes.substr(0, stl_header);
  if (has_controls(start)) return false;
  const std::size_t first = start.find_first_not_of("\xef\xbb\xbf \t\r\n");
  return first != start.npos &&
         (start[first] == '<' || start[first] == '{' || start.find_first_of("\r\n") != start.npos);
}

/// Not even by intention: it begins as files of another kind do, or the count would be a file of
/// 13 GB at least, which four letters of a text make.
bool is_of_another_kind(std::string_view bytes) {
  constexpr std::uint32_t too_many = 1U << 28, not_filled_in = 0xffffffff;
  const std::string_view kinds[] = {"PK\x03\x04", "\x89PNG",  "%PDF", "glTF",    "ISO-10303",
                                    "\x1f\x8b",   "\xff\xd8", "GIF8", "\177ELF", "<?xml",
                                    "ply\n",      "ply\r",    "OFF"};
  return is_other_text(bytes) ||
         std::ranges::any_of(kinds,
                             [&](std::string_view kind) { return bytes.starts_with(kind); }) ||
         (bytes.size() >= stl_header && little_endian(bytes, 80) >= too_many &&
          little_endian(bytes, 80) != not_filled_in);
}

[[noreturn]] void refuse_stl(const std::string& file, std::string_view bytes) {
  if (is_of_another_kind(bytes))
    throw InputError::in(file, "is not an STL file (it begins with " + first_bytes(bytes) + ")");
  if (bytes.size() < stl_header)
    throw InputError::in(file,
                         "too short for an STL file (it begins with " + first_bytes(bytes) + ")");
  const std::uint64_t n = little_endian(bytes, 80);
  throw InputError::at_byte(file, 80,
                            "the header declares " + std::to_string(n) + " triangles, that is " +
                                std::to_string(stl_header + n * stl_record) +
                                " bytes, but the file has " + std::to_string(bytes.size()));
}

/// "solid" alone does not tell: binary files begin with it as well. But text has no control
/// characters, and the numbers of a binary file hardly do without.
bool looks_like_text_stl(std::string_view bytes) {
  // A file of few triangles may end in a NUL or Ctrl-Z.
  const std::string_view start = bytes.substr(0, bytes.size() - end_marks(bytes)).substr(0, 1024);
  if (has_controls(start)) return false;
  const std::size_t first = start.find_first_not_of("\xef\xbb\xbf \t\r\n");
  if (first == start.npos) return false;
  std::string word(start.substr(first, 5));
  for (char& c : word) c = static_cast<char>(c | 0x20);
  return word == "solid";
}

}  // namespace

PolygonSoup read_stl(const std::string& file, std::string_view bytes, const Progress& progress) {
  const std::optional<BinaryStl> binary = binary_stl(bytes);
  // A text may happen to be a binary file with bytes after its end.
  if (binary && binary->left == 0 && !binary->has_placeholder())
    return read_binary_stl(file, bytes, *binary, progress);
  if (looks_like_text_stl(bytes)) return read_text_stl(file, plain_text(file, bytes), progress);
  if (binary) return read_binary_stl(file, bytes, *binary, progress);
  plain_text(file, bytes);  // says where it is text in another encoding
  refuse_stl(file, bytes);
}

}  // namespace sonde
