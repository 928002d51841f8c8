// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/contact_force.hpp"

namespace sonde {
namespace {

constexpr double opposed = 1e-3;  // share of all multipliers: below it, the forces cancel

}  // namespace

double force_per_multiplier(const Wrench& wrench, const ContactClusters& clusters,
                            const Vec3& com) {
  Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  double all = 0;
  for (const ContactCluster& each : clusters) {
    const Contact& c = each.contact;
    force += c.multiplier * c.normal;
    torque += c.multiplier * (c.on_fixed - com).cross(c.normal);
    all += c.multiplier;
  }
  if (force.norm() > opposed * all) return wrench.force.dot(force) / force.squaredNorm();
  return torque.squaredNorm() > 0 ? wrench.torque.dot(torque) / torque.squaredNorm() : 0;
}

}  // namespace sonde
