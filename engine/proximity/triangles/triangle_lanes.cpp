// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/triangles/triangle_lanes.hpp"

#define SONDE_LANES 2
#include "engine/proximity/triangles/triangle_lanes_kernel.hpp"

namespace sonde {
namespace {

using Kernel = void (*)(const TrianglePairs8&, int, double, ClosestPoints8&);

Kernel kernel(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::avx512) return closest_points_in_lanes<8>;
  if (set == InstructionSet::avx2) return closest_points_in_lanes<4>;
#endif
  return set == InstructionSet::baseline ? closest_points_in_lanes<2> : nullptr;
}

}  // namespace

void closest_points_by(InstructionSet set, const TrianglePairs8& pairs, int count, double limit,
                       ClosestPoints8& out) {
  kernel(set)(pairs, count, limit, out);
}

void closest_points(const TrianglePairs8& pairs, int count, double limit, ClosestPoints8& out) {
  static const Kernel chosen = kernel(instruction_set());
  chosen(pairs, count, limit, out);
}

ClosestPoints closest_points(const Corners& a, const Corners& b, double limit) {
  TrianglePairs8 pairs;
  set_lane(pairs, 0, a, b);
  ClosestPoints8 out;
  closest_points_in_lanes<2>(pairs, 1, limit, out);
  if (!(out.distance[0] < std::numeric_limits<double>::infinity()))
    return {Vec3::Zero(), Vec3::Zero(), out.distance[0], Vec3::Zero(), out.distance[0]};
  if (!(out.distance[0] > 0)) return {on_a(out, 0), on_b(out, 0), 0, Vec3::Zero(), 0};
  return {on_a(out, 0), on_b(out, 0), out.distance[0], normal(out, 0), out.gap[0]};
}

}  // namespace sonde
