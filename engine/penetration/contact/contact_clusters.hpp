// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The clusters of the contacts that hold a probe of the given radius, m. Two contacts belong
/// together where they are near each other and their normals agree, or where they lie in one plane,
/// however far apart. Contacts that are joined through others also belong together. Each cluster is
/// the wrench that its rows add up to: one force along an axis, at the centre of pressure, and a
/// couple about it (Poinsot, 1803). That is exact, whatever the normals: Σ λJ over the clusters is
/// Σ λJ over the contacts, to rounding. Where the normals are parallel there is no couple. The
/// representative is a positive combination of the cluster's rows, so any motion that satisfies the
/// rows satisfies it. The clusters are in the order of their first contacts; ids are left 0. Never
/// allocates.
ContactClusters contact_clusters(const ContactSet& contacts, double radius) noexcept;

/// The share of a contact in the sum of the multipliers of all clusters, 0 to 1. 0 if that sum is
/// 0.
double share_of_force(const Contact& contact, const ContactClusters& all) noexcept;

/// Keeps the ids of clusters from tick to tick. A cluster takes the id of a cluster of the last
/// tick if the two satisfy the criterion for two contacts of one cluster. Their points and normals
/// are compared both in the probe's frame and in the fixed body's frame; one match suffices. So a
/// corner that slides over triangles keeps its id, and so does an edge that slides over a corner.
/// The nearest clusters are matched first. A cluster without a match gets a new id; no id is given
/// twice. Never allocates.
class ClusterIds {
 public:
  /// Sets the ids of the clusters of one separation. `X_FM` is the separated pose, `radius` (m) the
  /// probe's radius.
  void follow(const Pose& X_FM, double radius, ContactClusters& clusters) noexcept;
  /// Call it before clusters that are unrelated to the previous ones.
  void forget() noexcept { last_.size = 0; }

 private:
  ContactClusters last_;
  Pose last_X_FM_;
  std::uint64_t given_ = 0;
};

}  // namespace sonde
