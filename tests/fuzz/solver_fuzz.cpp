// SPDX-License-Identifier: GPL-3.0-or-later
// Two small soups on a coarse grid, where contacts are often exact, flush or degenerate, and poses:
// what every answer promises must hold. Reference: the exact overlap test (CGAL's predicates).
#include <array>
#include <cmath>
#include <span>

#include "engine/body/body.hpp"
#include "engine/geometry/mass.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace sonde;
using fuzz::Bytes;
using fuzz::require;

PolygonSoup soup(Bytes& bytes) {
  PolygonSoup out;
  const std::size_t points = 3 + bytes.count(9);
  for (std::size_t i = 0; i < points; ++i) {
    const double x = bytes.on_grid(), y = bytes.on_grid(), z = bytes.on_grid();
    out.points.emplace_back(x, y, z);
  }
  const std::size_t triangles = 1 + bytes.count(11);
  for (std::size_t i = 0; i < triangles; ++i)
    out.polygons.push_back(
        {bytes.count(points - 1), bytes.count(points - 1), bytes.count(points - 1)});
  return out;
}

/// Both at one size out of many, 1e-9 to 1e9.
PolygonSoup scaled(PolygonSoup soup, double scale) {
  for (Vec3& x : soup.points) x *= scale;
  return soup;
}

Pose pose(Bytes& bytes, double scale) {
  const double x = bytes.on_grid(), y = bytes.on_grid(), z = bytes.on_grid();
  Quat q(bytes.on_grid(), bytes.on_grid(), bytes.on_grid(), bytes.on_grid());
  if (!(q.norm() > 0)) q = Quat::Identity();
  return {q.normalized(), scale * Vec3(x, y, z)};
}

bool same_bits(const Pose& a, const Pose& b) { return a.p == b.p && a.q.coeffs() == b.q.coeffs(); }

/// By its definition: the root of the mean squared displacement of the probe's points, from their
/// mean and their second moments.
double displacement(const MassProperties& mass, const Pose& from, const Pose& to) {
  const Transform a(from), b(to);
  const Vec3 moments = Vec3::Constant(mass.inertia.sum() / 2) - mass.inertia;
  const Mat3 turned = (a.R - b.R) * mass.R_MP;
  return std::sqrt((a * mass.com - b * mass.com).squaredNorm() +
                   (turned * moments.asDiagonal() * turned.transpose()).trace());
}

/// What rounding leaves of a displacement between two poses.
double rounding(const MassProperties& mass, const Pose& from, const Pose& to) {
  return 1e-7 * displacement(mass, from, to) +
         1e-13 * (from.p.norm() + to.p.norm() + mass.com.norm() + mass.radius);
}

/// m: by so much a tick may rise at most, where the probe regains its gaps (CoherentSolver).
double regained(const MassProperties& mass, double depth) {
  return allowed_clearance(mass.radius, depth) / 4;
}

void check(const Pair& pair, const Separation& s, const Pose& device, Method method) {
  if (s.status == Status::failed) {
    require(s.reason != nullptr && *s.reason != 0, "a failure has a reason");
    return;
  }
  require(same_bits(s.device, {device.q.normalized(), device.p}),
          "the answer is to the pose asked about");
  require(std::isfinite(s.depth) && s.depth >= 0, "a depth is a number");
  require(s.separated.p.allFinite() && s.separated.q.coeffs().allFinite(), "a pose is a pose");
  require(!overlap(pair.probe(), pair.fixed(), Transform(s.separated), Doubt::exact),
          "a pose called free is free");
  require(std::abs(s.depth * s.depth - s.sigma) <= 1e-9 * s.sigma,
          "the depth is the root of sigma");
  const MassProperties& mass = pair.probe().mass;
  require(std::abs(s.depth - displacement(mass, device, s.separated)) <=
              rounding(mass, device, s.separated),
          "the depth is how far the probe moves to the separated pose");
  if (method == Method::pdt && s.converged)  // a followed probe may be kept from turning along
    require(s.separated.q.angularDistance(s.device.q) <= 1e-7, "a translation turns nothing");
  if (s.lower_bound)
    require(*s.lower_bound <= s.depth * (1 + 1e-9), "a lower bound lies below the depth");
  if (s.status == Status::separated)
    require(s.depth == 0 && same_bits(s.separated, s.device), "what is separated stays");
  for (const Contact& c : s.contacts)
    require(c.multiplier >= 0 && std::abs(c.normal.norm() - 1) < 1e-6, "a contact pushes");
}

void check_static(const Pair& pair, const Pose& device) {
  for (const Method method : {Method::pdg, Method::pdt}) {
    const StaticOptions options{
        .method = method, .budget = {.steps = 200}, .starts = 16, .agreement = 2};
    const Separation s = separate_static(pair, device, options);
    check(pair, s, device, method);
    const Separation again = separate_static(pair, device, options);
    require(s.status == again.status && same_bits(s.separated, again.separated) &&
                s.lower_bound == again.lower_bound,
            "the same search gives the same bits");
  }
}

void check_followed(const Pair& pair, std::span<const Pose> path) {
  const MassProperties& mass = pair.probe().mass;
  for (const Method method : {Method::pdg, Method::pdt}) {
    CoherentSolver solver(pair, method);
    check(pair, solver.reset(path[0], {.budget = {.steps = 100}, .starts = 8, .agreement = 2}),
          path[0], method);
    for (const Pose& device : path.subspan(1)) {
      if (solver.last().status == Status::failed) break;
      const Pose before = solver.last().separated;
      const Separation& s = solver.tick(device, {.work = 200'000});
      check(pair, s, device, method);
      if (method == Method::pdg && s.status != Status::failed)
        require(s.depth <= displacement(mass, device, before) + regained(mass, s.depth) +
                               rounding(mass, device, before),
                "on the path to the separated pose the displacement does not rise");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  constexpr std::array scales{1.0, 1e-3, 1e-9, 1e9, 1.0 / 3};
  const double scale = scales[bytes.count(scales.size() - 1)];
  const Model model = bytes.count(1) == 0 ? Model::automatic : Model::surface;
  try {
    const PolygonSoup probe = scaled(soup(bytes), scale), fixed = scaled(soup(bytes), scale);
    const Pair pair(make_body(probe, model, "probe"), make_body(fixed, model, "fixed"));
    std::array<Pose, 4> path;
    for (Pose& at : path) at = pose(bytes, scale);
    check_static(pair, path[0]);
    check_followed(pair, path);
  } catch (const InputError&) {  // no triangle with an area
  }
  return 0;
}
