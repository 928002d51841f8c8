// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

struct InsertionPath;

/// The first point at which a path is blocked.
struct FirstContact {
  double travel = 0;  ///< m: everything before it is free
  Pose X_FM;          ///< the pose there
  Contact contact;    ///< F
  /// m: the bodies touch no later than so much further on. 1e-9 of the whole travel, but where the
  /// gap closes so slowly that it is rounding sooner: the travel to a pose that touches, or to the
  /// end of the path where none was found.
  double tolerance = 0;
};

/// Throws InputError if the bodies touch or overlap at the start of a path.
void check_start(const Pair& pair, const InsertionPath& way);

/// Throws as first_contact does, but finds nothing: a sweep is made only where the path leads so
/// far out that it may be refused there.
void check_way(const Pair& pair, const InsertionPath& way, const Progress& progress = {});

/// Uses sweeps, which skip nothing. A sweep stops at a small gap, which may be long along the path
/// where it closes slowly; so more sweeps go on from there, each through half of the gap that is
/// left, until a pose that touches, by the exact test, is near enough. None if the whole path is
/// free. Throws as check_start does, InputError if a pose is not finite, or if the path leads too
/// far from the origin for the size of the probe, and Cancelled.
std::optional<FirstContact> first_contact(const Pair& pair, const InsertionPath& way,
                                          const Progress& progress = {});

}  // namespace sonde
