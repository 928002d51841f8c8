// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/rendering/discontinuities.hpp"

#include <algorithm>

#include "engine/penetration/descent/descent.hpp"

namespace sonde {

bool popped_through(const RenderedTick& before, const RenderedTick& now, double radius) {
  if (before.failed || now.failed || before.force.isZero(0)) return false;
  const double fall = before.depth - now.depth;
  const double most = now.moved * (1 + 1e-9) + 2 * allowed_clearance(radius, before.depth);
  return fall > most && before.force.dot(now.force) <= 0;
}

Discontinuities discontinuities(const Rendering& rendering, double k, double radius) {
  Discontinuities out;
  for (std::size_t i = 1; i < rendering.size(); ++i) {
    const RenderedTick& before = rendering[i - 1];
    const RenderedTick& now = rendering[i];
    if (before.failed || now.failed) continue;
    const double deepest = std::max(before.depth, now.depth);
    const double allowed = k * (2 * now.moved + 2 * allowed_clearance(radius, deepest));
    const double force = (now.force - before.force).norm();
    const double torque = (now.torque - before.torque).norm();
    out.jumps += now.jumped;
    out.force_steps += force > allowed;
    out.torque_steps += torque > radius * allowed;
    out.pop_throughs += popped_through(before, now, radius);
    out.largest_force_step = std::max(out.largest_force_step, force);
    out.largest_torque_step = std::max(out.largest_torque_step, torque);
  }
  return out;
}

}  // namespace sonde
