// SPDX-License-Identifier: GPL-3.0-or-later
// Two small soups on a coarse grid, where contacts are often exact, flush or degenerate, and poses:
// what every answer promises must hold. Reference: the exact overlap test (CGAL's predicates).
#include <array>
#include <cmath>
#include <span>

#include "engine/body/body.hpp"
#include "engine/geometry/mass.hpp"
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

void check(const Pair& pair, const Separation& s, const Pose& device) {
  if (s.status == Status::failed) {
    require(s.reason != nullptr && *s.reason != 0, "a failure has a reason");
    return;
  }
  require(s.device.p == device.p, "the answer is to the pose asked about");
  require(std::isfinite(s.depth) && s.depth >= 0, "a depth is a number");
  require(s.separated.p.allFinite() && s.separated.q.coeffs().allFinite(), "a pose is a pose");
  require(!overlap(pair.probe(), pair.fixed(), Transform(s.separated), Doubt::exact),
          "a pose called free is free");
  require(std::abs(s.depth * s.depth - s.sigma) <= 1e-9 * s.sigma,
          "the depth is the root of sigma");
  if (s.lower_bound)
    require(*s.lower_bound <= s.depth * (1 + 1e-9), "a lower bound lies below the depth");
  if (s.status == Status::separated)
    require(s.depth == 0 && s.separated.p == device.p, "what is separated stays where it is");
  for (const Contact& c : s.contacts)
    require(c.multiplier >= 0 && std::abs(c.normal.norm() - 1) < 1e-6, "a contact pushes");
}

void check_static(const Pair& pair, const Pose& device) {
  for (const Method method : {Method::pdg, Method::pdt})
    check(
        pair,
        separate_static(pair, device,
                        {.method = method, .budget = {.steps = 200}, .starts = 16, .agreement = 2}),
        device);
}

void check_followed(const Pair& pair, std::span<const Pose> path) {
  CoherentSolver solver(pair);
  check(pair, solver.reset(path[0], {.budget = {.steps = 100}, .starts = 8, .agreement = 2}),
        path[0]);
  if (solver.last().status == Status::failed) return;
  for (const Pose& device : path.subspan(1))
    check(pair, solver.tick(device, {.work = 200'000}), device);
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
