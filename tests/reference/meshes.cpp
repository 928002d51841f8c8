// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "engine/base/elementary.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "tests/support/real_meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

/// A point of the wire's axis with two directions across it.
struct Station {
  Vec3 at;
  Vec3 across;
  Vec3 up = Vec3::UnitZ();
};

/// Rings about the stations, and a fan at either end.
PolygonSoup wire_mesh(const std::vector<Station>& stations, double wire, int sides) {
  PolygonSoup out;
  for (const Station& s : stations)
    for (int j = 0; j < sides; ++j) {
      const double angle = 2 * std::numbers::pi * j / sides;
      out.points.push_back(
          s.at + wire * (elementary::cos(angle) * s.across + elementary::sin(angle) * s.up));
    }
  const int last = static_cast<int>(stations.size()) - 1;
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(i * sides + j % sides); };
  const std::size_t begin = out.points.size(), end = begin + 1;
  out.points.push_back(stations.front().at);
  out.points.push_back(stations.back().at);
  for (int j = 0; j < sides; ++j) {
    for (int i = 0; i < last; ++i) {
      out.polygons.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
      out.polygons.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
    }
    out.polygons.push_back({begin, at(0, j + 1), at(0, j)});
    out.polygons.push_back({end, at(last, j), at(last, j + 1)});
  }
  return out;
}

void add(PolygonSoup& to, const PolygonSoup& part, const Vec3& at) {
  const std::size_t first = to.points.size();
  for (const Vec3& x : part.points) to.points.push_back(x + at);
  for (std::vector<std::size_t> polygon : part.polygons) {
    for (std::size_t& corner : polygon) corner += first;
    to.polygons.push_back(std::move(polygon));
  }
}

}  // namespace

std::shared_ptr<const Body> egg(double half_length, int rings) {
  PolygonSoup soup = test::sphere(half_length, rings, 2 * rings);
  for (Vec3& x : soup.points) x = x.cwiseProduct(Vec3(1, 0.75, 0.55));
  return make_body(soup, Model::solid, "egg");
}

std::shared_ptr<const Body> hook(double bow, double wire, double shank, int steps, int sides) {
  std::vector<Station> stations;
  stations.reserve(static_cast<std::size_t>(4 * steps + 1));
  for (int i = 0; i < steps; ++i)
    stations.push_back({Vec3(bow, shank * (1 - static_cast<double>(i) / steps), 0), Vec3::UnitX()});
  for (int i = 0; i <= 3 * steps; ++i) {
    const double angle = -1.25 * std::numbers::pi * i / (3 * steps);
    const Vec3 outward(elementary::cos(angle), elementary::sin(angle), 0);
    stations.push_back({bow * outward, outward});
  }
  return make_body(wire_mesh(stations, wire, sides), Model::solid, "hook");
}

std::shared_ptr<const Body> coil(double radius, double pitch, double turns, double wire, int steps,
                                 int sides) {
  std::vector<Station> stations;
  for (int i = 0; i <= steps; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / steps;
    const Vec3 out(elementary::cos(angle), elementary::sin(angle), 0), round(-out.y(), out.x(), 0);
    const Vec3 along =
        (radius * round + pitch / (2 * std::numbers::pi) * Vec3::UnitZ()).normalized();
    const double height = pitch * turns * (static_cast<double>(i) / steps - 0.5);
    stations.push_back({radius * out + height * Vec3::UnitZ(), out, out.cross(along)});
  }
  return make_body(wire_mesh(stations, wire, sides), Model::solid, "coil");
}

std::shared_ptr<const Body> lathe(const std::vector<Eigen::Vector2d>& section, int sides) {
  PolygonSoup soup;
  const std::size_t n = section.size(), m = static_cast<std::size_t>(sides);
  for (std::size_t j = 0; j < m; ++j) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(j) / sides;
    for (const Eigen::Vector2d& x : section)
      soup.points.emplace_back(x[0] * elementary::cos(angle), x[0] * elementary::sin(angle), x[1]);
  }
  for (std::size_t j = 0; j < m; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t k = (i + 1) % n, l = (j + 1) % m;
      soup.polygons.push_back({j * n + i, l * n + i, l * n + k, j * n + k});
    }
  return make_body(soup, Model::solid, "lathe");
}

std::shared_ptr<const Body> comb(int teeth, double tooth, double length) {
  const double pitch = 2.25 * tooth, width = 3 * tooth;
  PolygonSoup soup = test::box({teeth * pitch, tooth, width});
  for (int i = 0; i < teeth; ++i)
    add(soup, test::box({tooth, length, width}), {(i - 0.5 * (teeth - 1)) * pitch, length / 2, 0});
  return make_body(soup, Model::solid, "comb");
}

std::shared_ptr<const Body> dumbbell(double half_length, double rod, double knob) {
  PolygonSoup soup = test::sphere(1, 48, 24);
  for (Vec3& x : soup.points) {
    // Along the sphere's axis: the rod, and from seven tenths on half a circle of the knob.
    const double from_middle = (std::abs(x.z()) - 0.85) / 0.15;
    const double round = std::sqrt(std::max(0.0, 1 - from_middle * from_middle));
    const double radius = std::abs(x.z()) > 0.999999 ? 0 : std::max(rod, knob * round);
    const double across = elementary::hypot(x.x(), x.y());
    const Vec3 outward = across > 0 ? Vec3(x.x() / across, x.y() / across, 0) : Vec3::Zero();
    x = radius * outward + Vec3(0, 0, half_length * x.z());
  }
  return make_body(soup, Model::solid, "dumbbell");
}

std::shared_ptr<const Body> loose_triangles(int count, double size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return make_body(test::random_soup(random, count, size), Model::surface, "loose triangles");
}

std::shared_ptr<const Body> real(const std::string& file, double radius) {
  PolygonSoup soup = read_mesh(test::real_mesh(file));
  Eigen::AlignedBox3d box;
  for (const auto& polygon : soup.polygons)
    for (const std::size_t corner : polygon) box.extend(soup.points[corner]);
  double largest = 0;
  for (const auto& polygon : soup.polygons)
    for (const std::size_t corner : polygon)
      largest = std::max(largest, (soup.points[corner] - box.center()).norm());
  for (Vec3& x : soup.points) x = radius / largest * (x - box.center());
  return make_body(soup, Model::automatic, file);
}

std::shared_ptr<const Body> model(const std::string& file) {
  const auto path = std::filesystem::path(SONDE_MODELS) / file;
  return load_body(path.string(), Model::automatic, 1);
}

}  // namespace sonde::reference
