// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/read_mesh.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <new>
#include <optional>

#include "engine/geometry/cgal_readers.hpp"
#include "engine/geometry/mesh_checks.hpp"
#include "engine/geometry/topology.hpp"

namespace sonde {
namespace {

/// The part of a progress bar between two fractions.
Progress part_of(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [&progress, from, to](double f) { return progress(from + (to - from) * f); };
}

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
    if (progress && !progress(static_cast<double>(at) / static_cast<double>(size)))
      throw Cancelled();
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

PolygonSoup read_binary_stl(const std::string& file, std::string_view bytes,
                            const Progress& progress) {
  const std::uint64_t triangles = *declared_triangles(bytes);
  if (triangles == 0) throw InputError::in(file, "the mesh has no triangles");
  std::vector<Vec3> corners;
  corners.reserve(3 * triangles);
  for (std::uint64_t i = 0; i < triangles; ++i) {
    if (progress && (i & 0xffff) == 0 &&
        !progress(static_cast<double>(i) / static_cast<double>(triangles)))
      throw Cancelled();
    const std::size_t record = stl_header + i * stl_record + 12;  // after the normal
    for (std::size_t k = 0; k < 9; ++k) {
      const double x = std::bit_cast<float>(little_endian(bytes, record + 4 * k));
      if (!std::isfinite(x))
        throw InputError::at_byte(file, record + 4 * k,
                                  "a coordinate of triangle " + std::to_string(i + 1) + " of " +
                                      std::to_string(triangles) + " is not finite");
      if (k % 3 == 0) corners.emplace_back();
      corners.back()[static_cast<Eigen::Index>(k % 3)] = x;
    }
  }
  PolygonSoup soup;
  const std::vector<std::uint32_t> first = weld(corners);
  std::vector<std::size_t> index(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (first[i] == i) soup.points.push_back(corners[i]);
    index[i] = first[i] == i ? soup.points.size() - 1 : index[first[i]];
  }
  soup.polygons.reserve(triangles);
  for (std::size_t i = 0; i < index.size(); i += 3)
    soup.polygons.push_back({index[i], index[i + 1], index[i + 2]});
  return soup;
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
    if (progress && !progress(1)) throw Cancelled();
    return soup;
  } catch (const std::bad_alloc&) {
    throw InputError::in(file, "the mesh does not fit into memory");
  }
}

}  // namespace sonde
