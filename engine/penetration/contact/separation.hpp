// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/base/phase_times.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/penetration/contact/clearance.hpp"

namespace sonde {

/// The motions that a search considers: all six degrees of freedom (pdg), or translations only
/// (pdt).
enum class Method { pdg, pdt };
/// Outcome of a query. separated: the given pose is free. penetrating: it is not free, and the
/// answer holds the nearest free pose. failed: there is no answer, only a reason.
enum class Status { separated, penetrating, failed };

/// The words for the methods in files and on the command line, in the order of the enum.
inline constexpr std::array<const char*, 2> method_names{"pdg", "pdt"};
/// The word for a method in files and on the command line.
constexpr const char* name_of(Method method) {
  return method_names[static_cast<std::size_t>(method)];
}
/// The method that a word names; no value if the word names none.
constexpr std::optional<Method> method_named(std::string_view word) {
  for (const Method method : {Method::pdg, Method::pdt})
    if (word == name_of(method)) return method;
  return std::nullopt;
}
/// The word for a status in the results of the program.
constexpr const char* name_of(Status status) {
  switch (status) {
    case Status::separated:
      return "separated";
    case Status::penetrating:
      return "penetrating";
    case Status::failed:
      break;
  }
  return "failed";
}

/// One contact of a separated pose, in the fixed body's mesh frame, metres.
struct Contact {
  Vec3 on_probe = Vec3::Zero();  ///< a, the point on A at the separated pose
  Vec3 on_fixed = Vec3::Zero();  ///< b, the point on B
  Vec3 normal = Vec3::UnitZ();   ///< n, unit, from B to A
  double gap = 0;                ///< n·(a − b), m
  double multiplier = 0;         ///< λ ≥ 0 in metres: y = Jᵀλ at the optimum
};

/// The contacts that hold the separated pose (positive multiplier): at most six independent rows.
struct ContactSet {
  static constexpr int capacity = 8;    ///< maximum number of contacts
  std::array<Contact, capacity> items;  ///< the first `size` of them are valid
  int size = 0;                         ///< number of contacts
  /// The first contact.
  const Contact* begin() const { return items.data(); }
  /// One past the last contact.
  const Contact* end() const { return items.data() + size; }
  /// @pre 0 ≤ i < size.
  const Contact& operator[](int i) const { return items[static_cast<std::size_t>(i)]; }
  /// Appends a contact; returns false if there is no room.
  bool push(const Contact& c) {
    if (size == capacity) return false;
    items[static_cast<std::size_t>(size++)] = c;
    return true;
  }
};

/// Contacts that belong together, represented by the wrench that they add up to
/// (contact_clusters.hpp).
struct ContactCluster {
  /// The representative contact. Its normal is that of the resultant force, its multiplier λ the
  /// size of that force in metres, its points the centre of pressure.
  Contact contact;
  /// The couple about the normal per force, m: 0 where the normals are parallel. The cluster's row
  /// is J = (r × n + pitch n, n) in the weights of y, and y = Jᵀλ also holds over the clusters.
  double pitch = 0;
  int rows = 0;          ///< number of contacts in it
  std::uint64_t id = 0;  ///< constant from tick to tick; 0 in a static result
};

/// The clusters of a contact set: at most as many as it has contacts.
struct ContactClusters {
  std::array<ContactCluster, ContactSet::capacity> items;  ///< the first `size` of them are valid
  int size = 0;                                            ///< number of clusters
  /// The first cluster.
  ContactCluster* begin() { return items.data(); }
  /// One past the last cluster.
  ContactCluster* end() { return items.data() + size; }
  /// The first cluster.
  const ContactCluster* begin() const { return items.data(); }
  /// One past the last cluster.
  const ContactCluster* end() const { return items.data() + size; }
  /// @pre 0 ≤ i < size.
  const ContactCluster& operator[](int i) const { return items[static_cast<std::size_t>(i)]; }
};

/// The answer to one penetration query: plain data, no allocation. Poses are X_FM, the probe's mesh
/// frame M in the fixed body's mesh frame F.
struct Separation {
  Status status = Status::failed;  ///< if failed, `reason` says why, and no number is valid
  const char* reason = "";         ///< why it failed; static text
  Pose device;                     ///< O, the given pose
  /// Q; equals O where the status is separated. The static search tests with exact predicates that
  /// it is free, and the coherent solver reaches it along a path swept free. In the servo's local
  /// answer (Snapshot::separation) it is not tested.
  Pose separated;
  double sigma = 0;        ///< σ(O, Q), m²: mean squared displacement of the probe's points
  double depth = 0;        ///< √σ, m
  double translation = 0;  ///< |t|, the part of √σ from the displacement of the centre of mass, m
  double rotation = 0;     ///< 2√(vᵀÎv), the part of √σ from the rotation, m
  ContactSet contacts;     ///< the contacts that hold Q, in F; empty out of contact
  ContactClusters clusters;  ///< of the contacts
  double residual = 0;       ///< |y − Jᵀλ| / |y|, 0 where y = 0
  int iterations = 0;        ///< linearise-solve-advance steps taken
  /// The pose satisfies the optimality conditions (`residual`). False if something ended the
  /// descent first: its budget, steps without progress, no room for more rows, or the rim of the
  /// chart.
  bool converged = false;
  /// Number of limits that acted in a tick, or in all descents of a search: maximum numbers of rows
  /// (a step was cut short), of looks at a path, of steps without progress, of a tick's own steps
  /// (60), the rim of the chart; where a descent has not converged, also sweeps that took too much
  /// work, whose paths were cut into shorter ones. One more is counted if a search made all its
  /// starts without evidence that it has found the optimum. The result is verified in any case.
  int limited = 0;
  /// Coherent only: the force is discontinuous here. After a reset, Q was found by a search, not
  /// along a path. In a tick, the last separated pose was no longer a local optimum, and the path
  /// swept free led to a different one: the depth fell by more than the device moved, or on a part
  /// of the path more steeply than the device's motion explains (with translation only: by more
  /// than any point of the device moved). If the fall takes several ticks, true in each of them.
  /// With turns also wherever a probe that is behind, because a tick has not converged, has let go
  /// more of σ than a quarter of what the gap at its contacts amounts to.
  bool jumped = false;
  /// Coherent only: the tick `jumped` for no other reason than that the probe was behind and let
  /// energy go as it caught up: it went on where it was going, faster than the device.
  bool lagged = false;
  /// m², coherent only: in a tick that jumped, the part of σ that is no longer stored in the
  /// coupling and was not returned to the hand either; in one that lagged, with that of the ticks
  /// before it that let go too little to say so. The energy lost is ½ k times that. 0 in any
  /// other tick.
  double released = 0;
  /// Coherent only: whether the separated pose left a local optimum for another one, in this tick
  /// or (after a reset) by a search.
  bool fell() const noexcept { return jumped && !lagged; }
  /// Static only: the separating motion is long compared with the overlap: the depth is over 2.5
  /// times the depth of a sketch's deepest point (SearchTuning::narrow). A shorter separating
  /// motion may exist through a gap so narrow that few starts come near it, so the error stated for
  /// such an answer is larger (AccuracyCurve). False if there are no sketches.
  bool far_out = false;
  std::optional<double> lower_bound;  ///< a certified lower bound of the depth, m
  /// Static only: the translational depth, m, an intermediate result of the search: PD_t if nothing
  /// limits the search, otherwise an upper bound of it. None if the time ran out before that.
  std::optional<double> pdt;
  /// Static only: the distance of the bodies, if it was asked for and the pose is free.
  std::optional<Clearance> clearance;
  PhaseTimes phases;  ///< where the time went, if it was asked for
};

/// The work that one query may do; 0 means no limit of that kind. `steps` counts iterations of the
/// local optimiser, and `work` the units of Effort of a tick (both give the same bits on every
/// machine). `microseconds` is wall-clock time. A budget that is negative or NaN is invalid.
struct Budget {
  int steps = 0;            ///< iterations; 0: no limit
  double microseconds = 0;  ///< wall-clock time, µs; 0: no limit
  std::int64_t work = 0;    ///< coherent only
};
/// Whether no limit is negative or NaN.
constexpr bool is_valid(const Budget& budget) {
  return budget.steps >= 0 && budget.work >= 0 && budget.microseconds >= 0;
}

}  // namespace sonde
