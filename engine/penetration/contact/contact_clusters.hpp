// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// The clusters of the contacts that hold a probe of the given radius, m. Contacts are together
/// where they are near each other and their normals agree, or where they lie in one plane, however
/// wide; and so are those that others join. Each cluster is the wrench that its rows add up to: one
/// force along an axis, at the centre of pressure, and a couple about it (Poinsot, 1803). That is
/// exact, whatever the normals: Σ λJ over the clusters is Σ λJ over the contacts, to rounding.
/// Where the normals are parallel there is no couple. Any motion that satisfies the rows of a
/// cluster satisfies that of its representative, of which they are a positive combination. In the
/// order of their first contacts; ids are left 0. Never allocates.
ContactClusters contact_clusters(const ContactSet& contacts, double radius) noexcept;

/// Keeps the ids of clusters from tick to tick. A cluster is that of the last tick where it is
/// together with it, as contacts are, seen from the probe or from the fixed body: so a corner that
/// slides over triangles keeps its id, and so does an edge that slides over a corner. Nearest
/// first; what is left is new, and no id is given twice. Never allocates.
class ClusterIds {
 public:
  /// Gives the clusters of a probe of the given radius, m, separated to X_FM, their ids.
  void follow(const Pose& X_FM, double radius, ContactClusters& clusters) noexcept;
  /// What comes next has nothing to do with what was followed before.
  void forget() noexcept { last_.size = 0; }

 private:
  ContactClusters last_;
  Pose last_X_FM_;
  std::uint64_t given_ = 0;
};

}  // namespace sonde
