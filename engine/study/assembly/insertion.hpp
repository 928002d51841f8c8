// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/haptics/coupling/coupling.hpp"
#include "engine/queries/pair_queries.hpp"

namespace sonde {

/// A way on which a part is put in: poses X_FM, from each to the next with the centre of mass on a
/// straight line and the turn about one axis, and how far each is along the way.
struct InsertionWay {
  std::vector<Pose> poses;
  std::vector<double> travel;  ///< m: length of the way of the centre of mass, from 0
};

/// Along an axis (F, of any length but 0) by `travel` (m), while it turns about the axis through
/// its centre of mass by `twist` (rad): a screw. Throws InputError where the axis has no length,
/// the travel is not positive, a number is not finite, or the twist is beyond a million radians.
InsertionWay way_along(const Pair& pair, const Pose& start, const Vec3& axis, double travel,
                       double twist);
/// Through the poses given. Throws InputError where there are less than two, or the way has no
/// length.
InsertionWay way_through(const Pair& pair, const std::vector<Pose>& poses);

/// The pose of a way so far along it, m.
Pose pose_at(const InsertionWay& way, const Pair& pair, double travel);

/// Where a way is first blocked.
struct FirstContact {
  double travel = 0;  ///< m: all before it is free
  Pose X_FM;          ///< the pose there
  Contact contact;    ///< F
};
/// By sweeps, which skip nothing: placed to what SweptPath::free says. None where all of the way is
/// free. Throws InputError where the bodies touch or overlap where it begins.
std::optional<FirstContact> first_contact(const Pair& pair, const InsertionWay& way);

/// The probe at one place of the way.
struct InsertionStep {
  double travel = 0;    ///< m
  Pose X_FM;            ///< where the way has it
  Clearance clearance;  ///< there: least distance and its points
  Separation held;      ///< where it is held, if it is followed from the beginning of the way
  Wrench wrench;        ///< on the hand, by the coupling, without limits
};

/// What happens on a way.
struct Insertion {
  std::vector<InsertionStep> steps;
  std::optional<FirstContact> first;
};

/// Follows the probe along a way in so many steps, and more about the first contact: each interval
/// in which the contact begins is halved until it is 1e-3 of a step. Throws InputError as
/// first_contact, and Cancelled.
Insertion insertion(const Pair& pair, const InsertionWay& way, std::size_t steps,
                    const Coupling& coupling, const Progress& progress = {});

}  // namespace sonde
