// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "engine/mesh_io/read_mesh.hpp"
#include "tests/support/real_meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::bench {
namespace {

/// Debian's glmark2-data, optional.
constexpr const char* glmark2_models = "/usr/share/glmark2/models";

struct Source {
  const char* file;
  bool glmark2;
};
const std::map<std::string, Source> real_sources = {
    {"bunny", {"bunny00.off", false}},
    {"armadillo", {"armadillo.off", false}},
    {"dragon", {"ChineseDragon-10kv.off", false}},
    {"elephant", {"refined_elephant.off", false}},
    {"knot", {"knot2.off", false}},
    {"glmark2-bunny", {"bunny.obj", true}},
};

PolygonSoup unit_sized(PolygonSoup soup) {
  Eigen::AlignedBox3d box;
  for (const auto& polygon : soup.polygons)
    for (const std::size_t corner : polygon) box.extend(soup.points[corner]);
  double radius = 0;
  for (Vec3& x : soup.points) x -= box.center();
  for (const auto& polygon : soup.polygons)
    for (const std::size_t corner : polygon) radius = std::max(radius, soup.points[corner].norm());
  for (Vec3& x : soup.points) x *= mesh_radius / radius;
  return soup;
}

int steps(double count) { return std::max(3, static_cast<int>(std::lround(count))); }

/// "32k" is 32 000, "1M" a million.
std::size_t count_of(const std::string& text) {
  std::size_t end = 0;
  const std::size_t count = std::stoul(text, &end);
  const std::string unit = text.substr(end);
  return count * (unit == "M" ? 1'000'000 : unit == "k" ? 1000 : 1);
}

std::filesystem::path file_of(const Source& source) {
  if (!source.glmark2) return test::real_mesh(source.file);
  std::filesystem::path path = std::filesystem::path(glmark2_models) / source.file;
  if (!std::filesystem::is_regular_file(path))
    throw std::runtime_error(path.string() + " is missing: install glmark2-data");
  return path;
}

}  // namespace

PolygonSoup sphere_mesh(std::size_t triangles) {
  const int rings = steps(std::sqrt(static_cast<double>(triangles) / 4));
  return unit_sized(test::sphere(1, rings, 2 * rings));
}

PolygonSoup ring_mesh(std::size_t triangles) {
  const int around_tube = steps(std::sqrt(static_cast<double>(triangles) / 8));
  return unit_sized(test::torus(ring_middle_radius, mesh_radius - ring_middle_radius,
                                4 * around_tube, around_tube));
}

PolygonSoup trefoil_mesh(std::size_t triangles) {
  const int sides = steps(std::sqrt(static_cast<double>(triangles) / 20));
  return unit_sized(test::torus_knot(2, 3, 0.6, 0.25, 0.15, 10 * sides, sides));
}

PolygonSoup mesh(const std::string& name) {
  const auto real = real_sources.find(name);
  if (real != real_sources.end()) return unit_sized(read_mesh(file_of(real->second)));
  const std::size_t dash = name.find('-');
  const std::string shape = name.substr(0, dash);
  const std::size_t triangles = count_of(name.substr(dash + 1));
  if (shape == "sphere") return sphere_mesh(triangles);
  if (shape == "ring") return ring_mesh(triangles);
  if (shape == "trefoil") return trefoil_mesh(triangles);
  throw std::invalid_argument("no mesh is called " + name);
}

std::string why_missing(const std::string& name) {
  const auto real = real_sources.find(name);
  if (real == real_sources.end()) return {};
  try {
    file_of(real->second);
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

}  // namespace sonde::bench
