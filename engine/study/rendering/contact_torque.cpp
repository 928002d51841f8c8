// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/rendering/contact_torque.hpp"

#include <algorithm>

#include "engine/penetration/descent/descent.hpp"

namespace sonde {
namespace {

/// Weight of an arm of the probe's radius relative to the translation; turns are weighted by its
/// square.
constexpr double share = 0.01;

Vec3 arm_moment(const Contact& contact, const Vec3& com) {
  return (contact.on_fixed - com).cross(contact.normal);
}

}  // namespace

ContactTorque::ContactTorque(const Body& probe, const Body& fixed)
    : probe_(probe), rows_(probe, fixed, Method::pdt, {.most_pairs = 512, .keeps_lists = false}) {}

Vec3 ContactTorque::at(const Separation& separation) {
  if (separation.status != Status::penetrating) return Vec3::Zero();
  const double clearance = allowed_clearance(probe_.mass.radius, separation.depth);
  const double margin = 0.5 * clearance;
  const Chart chart(probe_.mass, separation.device);
  rows_.gather(chart, chart.coordinates(separation.separated), 2 * clearance, 2 * clearance);

  const Vec3 com = separation.separated * probe_.mass.com;
  const Vec3 t = com - separation.device * probe_.mass.com;
  half_spaces_.clear();
  for (int i = 0; i < rows_.size(); ++i) {
    const Contact contact = rows_.contact(i);
    HalfSpace row;
    row.normal << share / probe_.mass.radius * arm_moment(contact, com), contact.normal;
    row.bound = contact.normal.dot(t) - std::max(0.0, contact.gap - margin);
    half_spaces_.push_back(row);
  }
  const LeastDistance nearest = least_distance(half_spaces_, 0.05 * margin);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < static_cast<std::size_t>(nearest.active_count); ++i)
    sum += nearest.multiplier[i] * arm_moment(rows_.contact(nearest.active[i]), com);
  return nearest.feasible ? sum : Vec3::Zero();
}

}  // namespace sonde
