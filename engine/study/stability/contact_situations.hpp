// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/scene/poses.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/stability/felt_stiffness.hpp"

namespace sonde {

/// The kinds of contact that hold a probe, by clusters (contact_clusters.hpp) and rows.
enum class ContactKind {
  flat,        ///< one cluster of one row: a point on a surface
  edge,        ///< one cluster of two rows: along a line
  conforming,  ///< one cluster of three rows or more: surfaces along each other
  corner,      ///< several clusters, no two of whose normals are 120° apart or more
  jammed,      ///< several clusters, two of which press against each other: 120° or more
};
constexpr ContactKind all_contact_kinds[] = {ContactKind::flat, ContactKind::edge,
                                             ContactKind::conforming, ContactKind::corner,
                                             ContactKind::jammed};
const char* name_of(ContactKind kind);
/// The kind of a penetrating separation; its contacts must not be empty.
ContactKind contact_kind(const Separation& separation);

/// A contact in which the coupling is studied.
struct ContactSituation {
  ContactKind kind = ContactKind::flat;
  Separation separation;    ///< as found by following the probe from outside
  FeltStiffness stiffness;  ///< there
};

struct SituationOptions {
  Method method = Method::pdg;
  std::uint64_t seed = 1;
  int walks = 160;      ///< of the probe into the fixed body
  double depth = 0.02;  ///< at which a walk has arrived, of the probe's radius
  /// Orders situations of one kind: the largest is the hardest. Called with its felt stiffness, on
  /// any thread.
  std::function<double(const FeltStiffness&)> hardness = {};
  /// Of the search; what is found is the same at any number.
  unsigned threads = 1;
  /// Gets the fraction of the search that is done, 0 to 1, now and then.
  std::function<void(double)> progress = {};
};

/// Contacts of the two bodies, at most `most` of each kind, in the order of the kinds and the
/// hardest first. They are found by walks: the probe comes from outside in a straight line, half of
/// the times at a random rotation and otherwise near X_FM, towards a random point of the fixed
/// body's box, until it has the wanted depth. Empty if no walk meets a contact. Throws Cancelled.
std::vector<ContactSituation> find_situations(const Pair& pair, const Pose& X_FM, int most,
                                              const SituationOptions& options, const Stop& stop);

/// The same for the contacts along a recorded path: from some 200 poses, evenly chosen among those
/// in contact.
std::vector<ContactSituation> situations_along(const Pair& pair, std::span<const TimedPose> path,
                                               int most, const SituationOptions& options,
                                               const Stop& stop);

}  // namespace sonde
