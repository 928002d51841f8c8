// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/queries/pair_queries.hpp"
#include "engine/study/assembly/first_contact.hpp"
#include "engine/study/assembly/least_room.hpp"

namespace sonde {

/// The path on which a part is inserted: poses X_FM with the travel at each. Between two poses, the
/// centre of mass moves on a straight line, and the turn is about one axis.
struct InsertionPath {
  std::vector<Pose> poses;
  std::vector<double> travel;  ///< m: path length of the centre of mass, from 0
};

/// A screw motion: a translation along an axis (F, of any length but 0) by `travel` (m), with a
/// turn about the axis through the centre of mass by `twist` (rad). Throws InputError if the axis
/// has no length, the travel is not positive or over a million radii of the probe, a number is
/// not finite, or the twist is beyond a million radians.
InsertionPath way_along(const Pair& pair, const Pose& start, const Vec3& axis, double travel,
                        double twist);
/// A path through the given poses. Throws InputError if there are fewer than two, or the path has
/// no length.
InsertionPath way_through(const Pair& pair, const std::vector<Pose>& poses);

/// The pose of a path at this travel, m.
Pose pose_at(const InsertionPath& way, const Pair& pair, double travel);

/// The probe at one point of the path.
struct InsertionStep {
  double travel = 0;    ///< m
  Pose X_FM;            ///< the pose on the path
  Clearance clearance;  ///< there: least distance and closest points
  Separation held;      ///< the separated pose, if the probe follows from the start
  Wrench wrench;        ///< on the hand, from the coupling, without limits
};

/// The results along a path.
struct Insertion {
  std::vector<InsertionStep> steps;
  std::optional<FirstContact> first;
  /// Least clearance where the path is free. That of a path that is blocked is 0 but for what the
  /// first contact and the steps leave, and is not searched for.
  LeastRoom room;
};

/// Units of Effort: the limit of the search for the least clearance, some seconds.
inline constexpr std::int64_t work_of_least_room = 200'000'000;

/// Follows the probe along a path in `steps` steps, and more about the first contact: the interval
/// in which the contact begins is halved until it is 1e-3 of a step. Throws InputError as
/// first_contact does, and Cancelled.
Insertion insertion(const Pair& pair, const InsertionPath& way, std::size_t steps,
                    const Coupling& coupling, const Progress& progress = {},
                    std::int64_t work = work_of_least_room);

}  // namespace sonde
