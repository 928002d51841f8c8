// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/one_projection.hpp"

#include <algorithm>

#include "engine/penetration/search/coherent.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde::reference {
namespace {

/// Ticks at the device pose; each is up to 60 projections.
constexpr int most_ticks = 10;

/// As far out as the balls about both bodies reach, away from the fixed body's centre.
Pose outside(const Pair& pair, const Pose& device) {
  const Body &probe = pair.probe(), &fixed = pair.fixed();
  const auto reach = [](const Body& body) {
    double most = 0;
    for (const Vec3& x : body.soup.vertices) most = std::max(most, (x - body.mass.com).norm());
    return most;
  };
  const Vec3 between = device * probe.mass.com - fixed.mass.com;
  const double length = between.norm();
  const Vec3 along = length > 0 ? Vec3(between / length) : Vec3::UnitZ();
  Pose out = device;
  out.p += (1.01 * (reach(probe) + reach(fixed)) - length) * along;
  return out;
}

}  // namespace

Measured measure_one_projection(const Row& row, const Pair& pair) {
  Measured out;
  out.row = row;
  out.reference = row.pdt;
  CoherentSolver solver(pair, Method::pdt);
  solver.reset(outside(pair, row.pose));
  out.time_us = processor_time_us([&] {
    for (int i = 0; i < most_ticks; ++i)
      if (solver.tick(row.pose).converged) break;
  });
  out.got = solver.last();
  out.free = out.got.status != Status::failed &&
             !overlap(pair.probe(), pair.fixed(), Transform(out.got.separated), Doubt::exact);
  return out;
}

}  // namespace sonde::reference
