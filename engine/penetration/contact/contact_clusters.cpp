// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/contact_clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/penetration/contact/contact_tuning.hpp"

namespace sonde {
namespace {

/// Cosine of the tilt ContactTuning::flat.
constexpr double level = 1 - 0.5 * contact_tuning.flat * contact_tuning.flat;

struct Place {
  Vec3 point;
  Vec3 normal;
};

/// Distance, m, of the points of two contacts if these belong to one cluster; infinite if they do
/// not.
double apart(const Place& p, const Place& q, double radius) {
  const double cosine = p.normal.dot(q.normal);
  const Vec3 way = q.point - p.point;
  const double distance = way.norm();
  const bool close = distance <= contact_tuning.near_by * radius && cosine >= contact_tuning.agreed;
  const bool in_one_plane =
      std::abs(p.normal.dot(way)) <= contact_tuning.flat * radius && cosine >= level;
  return close || in_one_plane ? distance : std::numeric_limits<double>::infinity();
}

Place place(const Contact& contact) { return {contact.on_fixed, contact.normal}; }

/// For each contact, the index of the first contact of its cluster.
using Groups = std::array<int, ContactSet::capacity>;

Groups group(const ContactSet& contacts, double radius) {
  Groups first{};
  for (int i = 0; i < contacts.size; ++i) {
    first[static_cast<std::size_t>(i)] = i;
    for (int j = 0; j < i; ++j) {
      if (!std::isfinite(apart(place(contacts[i]), place(contacts[j]), radius))) continue;
      const auto [to, from] =
          std::minmax(first[static_cast<std::size_t>(i)], first[static_cast<std::size_t>(j)]);
      std::replace(first.begin(), first.begin() + i + 1, int{from}, int{to});
    }
  }
  return first;
}

/// The resultant wrench of the contacts of one group.
ContactCluster resultant(const ContactSet& contacts, const Groups& first, int group) {
  ContactCluster out;
  Vec3 force = Vec3::Zero(), on_probe = Vec3::Zero(), on_fixed = Vec3::Zero();
  double weight = 0, gap = 0;
  for (int i = group; i < contacts.size; ++i) {
    if (first[static_cast<std::size_t>(i)] != group) continue;
    const Contact& c = contacts[i];
    force += c.multiplier * c.normal;
    on_probe += c.multiplier * c.on_probe;
    on_fixed += c.multiplier * c.on_fixed;
    gap += c.multiplier * c.gap;
    weight += c.multiplier;
    ++out.rows;
  }
  if (out.rows == 1) {
    out.contact = contacts[group];
    return out;
  }
  on_probe /= weight;
  on_fixed /= weight;
  Vec3 moment = Vec3::Zero();  // about on_probe
  for (int i = group; i < contacts.size; ++i)
    if (first[static_cast<std::size_t>(i)] == group)
      moment +=
          contacts[i].multiplier * (contacts[i].on_probe - on_probe).cross(contacts[i].normal);
  const double size = force.norm();
  const Vec3 normal = force / size;
  const Vec3 to_axis = normal.cross(moment) / size;
  out.contact = {on_probe + to_axis, on_fixed + to_axis, normal, gap / size, size};
  out.pitch = normal.dot(moment) / size;
  return out;
}

}  // namespace

ContactClusters contact_clusters(const ContactSet& contacts, double radius) noexcept {
  const Groups first = group(contacts, radius);
  ContactClusters out;
  for (int i = 0; i < contacts.size; ++i)
    if (first[static_cast<std::size_t>(i)] == i)
      out.items[static_cast<std::size_t>(out.size++)] = resultant(contacts, first, i);
  return out;
}

double share_of_force(const Contact& contact, const ContactClusters& all) noexcept {
  double sum = 0;
  for (const ContactCluster& c : all) sum += c.contact.multiplier;
  return sum > 0 ? contact.multiplier / sum : 0;
}

void ClusterIds::follow(const Pose& X_FM, double radius, ContactClusters& clusters) noexcept {
  const Pose to_probe = inverse(X_FM), last_to_probe = inverse(last_X_FM_);
  const auto on_probe = [](const Pose& X_MF, const Contact& c) {
    return Place{X_MF * c.on_probe, X_MF.q * c.normal};
  };
  std::array<bool, ContactSet::capacity> taken{};
  for (ContactCluster& c : clusters) c.id = 0;
  for (;;) {
    double nearest = std::numeric_limits<double>::infinity();
    ContactCluster* found = nullptr;
    std::size_t from = 0;
    for (ContactCluster& c : clusters)
      for (std::size_t i = 0; i < static_cast<std::size_t>(last_.size); ++i) {
        if (c.id != 0 || taken[i]) continue;
        const Contact &now = c.contact, &then = last_.items[i].contact;
        const double distance =
            std::min(apart(place(now), place(then), radius),
                     apart(on_probe(to_probe, now), on_probe(last_to_probe, then), radius));
        if (distance < nearest) nearest = distance, found = &c, from = i;
      }
    if (!found) break;
    found->id = last_.items[from].id;
    taken[from] = true;
  }
  for (ContactCluster& c : clusters)
    if (c.id == 0) c.id = ++given_;
  last_ = clusters;
  last_X_FM_ = X_FM;
}

}  // namespace sonde
