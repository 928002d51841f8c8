// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/read_mesh.hpp"

#include <algorithm>
#include <fstream>
#include <new>
#include <optional>

#include "engine/base/progress.hpp"
#include "engine/mesh_io/assets/asset_readers.hpp"
#include "engine/mesh_io/mesh_readers.hpp"
#include "engine/mesh_io/size_remark.hpp"
#include "engine/mesh_io/unit_remark.hpp"

namespace sonde {
namespace {

enum class MeshFormat { off, obj, ply, stl, gltf, threemf, dae };

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

std::optional<MeshFormat> known_format(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".off") return MeshFormat::off;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".stl") return MeshFormat::stl;
  if (extension == ".glb" || extension == ".gltf") return MeshFormat::gltf;
  if (extension == ".3mf") return MeshFormat::threemf;
  if (extension == ".dae") return MeshFormat::dae;
  return std::nullopt;
}

MeshFormat format_of(const std::filesystem::path& path) {
  if (const auto known = known_format(path)) return *known;
  throw InputError::in(path.string(),
                       "unknown mesh format: OFF, OBJ, PLY, STL, GLB, glTF, 3MF and DAE are read");
}

std::string read_bytes(const std::filesystem::path& path, const Progress& progress) {
  const std::string file = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw InputError::in(file, "no such file");
  if (!std::filesystem::is_regular_file(status)) throw InputError::in(file, "not a regular file");
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  // The size of what is open: another file may take the name in the meantime.
  const std::streamoff end = stream.tellg();
  if (!stream.seekg(0) || end < 0) throw InputError::in(file, "cannot be opened");
  const auto size = static_cast<std::uintmax_t>(end);
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

PolygonSoup read(MeshFormat format, const std::string& file, std::string_view bytes,
                 const Progress& progress) {
  switch (format) {
    case MeshFormat::off:
      return read_off(file, bytes, progress);
    case MeshFormat::obj:
      return read_obj(file, bytes, progress);
    case MeshFormat::ply:
      return read_ply(file, bytes, progress);
    case MeshFormat::gltf:
      return read_gltf(file, bytes, progress);
    case MeshFormat::threemf:
      return read_3mf(file, bytes, progress);
    case MeshFormat::dae:
      return read_dae(file, bytes, progress);
    case MeshFormat::stl:
      break;
  }
  return read_stl(file, bytes, progress);
}

/// Where files of a format that has no unit may name one all the same.
UnitPlace unit_place_of(MeshFormat format) {
  if (format == MeshFormat::stl) return UnitPlace::stl_header;
  return format == MeshFormat::ply ? UnitPlace::ply_header : UnitPlace::comments;
}

}  // namespace

bool has_own_unit(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".glb" || extension == ".gltf" || extension == ".3mf" || extension == ".dae";
}

bool is_mesh_name(const std::filesystem::path& path) { return known_format(path).has_value(); }

PolygonSoup read_mesh(const std::filesystem::path& path, double scale, const Progress& progress) {
  const std::string file = path.string();
  const MeshFormat format = format_of(path);
  try {
    const std::string bytes = read_bytes(path, part_of(progress, 0, 0.1));
    PolygonSoup soup = read(format, file, bytes, part_of(progress, 0.1, 1));
    for (Vec3& x : soup.points) {
      x *= scale;
      if (!x.allFinite()) throw InputError::in(file, "a coordinate is not finite once scaled");
    }
    if (!has_own_unit(path)) remark_on_unit(soup, unit_place_of(format), bytes, scale);
    // A unit that the format states is no guess of the user's: no other is offered.
    remark_on_size(soup, has_own_unit(path) ? 0 : scale);
    report(progress, 1);
    return soup;
  } catch (const std::bad_alloc&) {
    throw InputError::in(file, "the mesh does not fit into memory");
  }
}

}  // namespace sonde
