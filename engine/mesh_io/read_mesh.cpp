// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/read_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <new>
#include <optional>

#include "engine/base/progress.hpp"
#include "engine/geometry/topology.hpp"
#include "engine/mesh_io/binary_off.hpp"
#include "engine/mesh_io/cgal_readers.hpp"
#include "engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

MeshFormat format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  throw InputError::in(path.string(), "unknown mesh format: OFF, OBJ, PLY and STL are read");
}

std::string read_bytes(const std::filesystem::path& path, const Progress& progress) {
  const std::string file = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError::in(file, "no such file");
  if (!std::filesystem::is_regular_file(status)) throw InputError::in(file, "not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  std::ifstream stream(path, std::ios::binary);
  if (error || !stream) throw InputError::in(file, "cannot be opened");
  if (size == 0) throw InputError::in(file, "the file is empty");
  std::string bytes(size, '\0');
  constexpr std::uintmax_t piece = 1 << 22;
  for (std::uintmax_t at = 0; at < size; at += piece) {
    report(progress, static_cast<double>(at) / static_cast<double>(size));
    stream.read(bytes.data() + at, static_cast<std::streamsize>(std::min(piece, size - at)));
    if (!stream) throw InputError::at_byte(file, at, "cannot be read");
  }
  return bytes;
}

// ------------------------------------------------------------------------------------ binary STL

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

/// "solid" alone does not tell, but text has no zero bytes.
bool looks_like_text_stl(std::string_view text) {
  if (text.substr(0, 1024).find('\0') != text.npos) return false;
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == text.npos) return false;
  std::string word(text.substr(start, 5));
  for (char& c : word) c = static_cast<char>(c | 0x20);
  return word == "solid";
}

/// One coordinate of a record: 0, 1 and 2 are those of the first corner.
double coordinate(const std::string& file, std::string_view bytes, std::size_t record,
                  std::size_t number) {
  const std::size_t at = stl_header + record * stl_record + 12 + 4 * number;  // after the normal
  const double x = std::bit_cast<float>(little_endian(bytes, at));
  if (!std::isfinite(x))
    throw InputError::at_byte(file, at,
                              "a coordinate of triangle " + std::to_string(record + 1) + " of " +
                                  std::to_string(*declared_triangles(bytes)) + " is not finite");
  return x;
}

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

PolygonSoup read_binary_stl(const std::string& file, std::string_view bytes,
                            const Progress& progress) {
  const std::uint64_t triangles = *declared_triangles(bytes);
  if (triangles == 0) throw InputError::in(file, "the mesh has no triangles");
  std::vector<Vec3> corners(3 * triangles);
  for_each_index(triangles, part_of(progress, 0, 0.3), [&](std::size_t i) {
    for (std::size_t k = 0; k < 9; ++k)
      corners[3 * i + k / 3][static_cast<Eigen::Index>(k % 3)] = coordinate(file, bytes, i, k);
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

// ----------------------------------------------------------------------------------- all formats

CheckedMesh check(MeshFormat format, const std::string& file, std::string_view text,
                  const Progress& progress) {
  switch (format) {
    case MeshFormat::off:
      return check_off(file, text, progress);
    case MeshFormat::obj:
      return check_obj(file, text, progress);
    case MeshFormat::ply:
      return check_ply(file, text, progress);
    case MeshFormat::stl:
      break;
  }
  return check_text_stl(file, text, progress);
}

/// CGAL's result against what was checked: if they differ, the fault is not the user's, but the
/// mesh must not pass.
void compare(const std::string& file, const CheckedMesh& checked, const PolygonSoup& soup) {
  bool good = (checked.points == 0 || soup.points.size() == checked.points) &&
              soup.polygons.size() == checked.polygons;
  for (const auto& polygon : soup.polygons)
    for (const std::size_t i : polygon) good = good && i < soup.points.size();
  for (const Vec3& x : soup.points) good = good && x.allFinite();
  if (!good) throw InputError::in(file, "the mesh cannot be read");
}

PolygonSoup parse(MeshFormat format, const std::string& file, std::string_view bytes,
                  const Progress& progress) {
  if (format == MeshFormat::stl && is_binary_stl(bytes))
    return read_binary_stl(file, bytes, progress);
  if (format == MeshFormat::off && is_binary_off(bytes))
    return read_binary_off(file, bytes, progress);
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
  if (format == MeshFormat::stl && !looks_like_text_stl(bytes)) refuse_stl(file, bytes);
  const CheckedMesh checked = check(format, file, bytes, part_of(progress, 0, 0.3));
  PolygonSoup soup;
  if (!parse_with_cgal(format, checked.text, soup, part_of(progress, 0.3, 1)))
    throw InputError::in(file, "the mesh cannot be read");
  compare(file, checked, soup);
  return soup;
}

}  // namespace

PolygonSoup read_mesh(const std::filesystem::path& path, double scale, const Progress& progress) {
  const std::string file = path.string();
  const MeshFormat format = format_of(path);
  try {
    const std::string bytes = read_bytes(path, part_of(progress, 0, 0.1));
    PolygonSoup soup = parse(format, file, bytes, part_of(progress, 0.1, 1));
    for (Vec3& x : soup.points) {
      x *= scale;
      if (!x.allFinite()) throw InputError::in(file, "a coordinate is not finite once scaled");
    }
    report(progress, 1);
    return soup;
  } catch (const std::bad_alloc&) {
    throw InputError::in(file, "the mesh does not fit into memory");
  }
}

}  // namespace sonde
