// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/asset_readers.hpp"

#include "engine/base/progress.hpp"
#include "engine/mesh_io/assets/dae_shape.hpp"
#include "engine/mesh_io/assets/gltf_shape.hpp"
#include "engine/mesh_io/assets/import.hpp"
#include "engine/mesh_io/assets/threemf_shape.hpp"

namespace sonde {
namespace {

PolygonSoup with_remarks(PolygonSoup soup, const std::vector<std::string>& remarks) {
  soup.remarks.insert(soup.remarks.end(), remarks.begin(), remarks.end());
  return soup;
}

}  // namespace

PolygonSoup read_gltf(const std::string& file, std::string_view bytes, const Progress& progress) {
  const GltfShape shape = gltf_shape(file, bytes);
  return with_remarks(import_model(file, shape.bytes, shape.binary ? "glb" : "gltf", 1,
                                   3 * shape.triangles, part_of(progress, 0.3, 1)),
                      shape.remarks);
}

PolygonSoup read_3mf(const std::string& file, std::string_view bytes, const Progress& progress) {
  const ThreeMfShape shape = threemf_shape(file, bytes, part_of(progress, 0, 0.4));
  return with_remarks(import_model(file, shape.bytes, "3mf", shape.metres, 3 * shape.triangles,
                                   part_of(progress, 0.4, 1)),
                      shape.remarks);
}

PolygonSoup read_dae(const std::string& file, std::string_view bytes, const Progress& progress) {
  const DaeShape shape = dae_shape(file, bytes, part_of(progress, 0, 0.4));
  // The library multiplies by the unit, in single precision.
  const double rest = shape.metres / static_cast<double>(static_cast<float>(shape.metres));
  return with_remarks(
      import_model(file, bytes, "dae", rest, shape.corners, part_of(progress, 0.4, 1)),
      shape.remarks);
}

}  // namespace sonde
