// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// Whether contacts are meaningless where coordinates of the probe's mesh origin are as large as
/// those of `farthest` (m, F): they are rounded by more than 1 % of the probe's radius.
bool is_rough(const Body& probe, const Body& fixed, const Vec3& farthest) noexcept;

/// Whether the probe is free at a pose, or the reason why that cannot be decided.
struct FreeTest {
  bool free = false;
  const char* fault = nullptr;
};
/// A pose that is not finite, or so far away that rounding makes it meaningless, has a fault. If
/// the probe is clear of the fixed body, however far away, or free by the exact test, it is free.
/// @pre A finite pose has a unit quaternion.
FreeTest test_free(const Body& probe, const Body& fixed, const Pose& X_FM);

/// The answer at poses that need no search, by test_free: separated as it is where the probe is
/// free, failed where there is a fault; no value if the bodies overlap.
/// @pre A finite pose has a unit quaternion.
std::optional<Separation> trivial_separation(const Body& probe, const Body& fixed,
                                             const Pose& X_FM);

}  // namespace sonde
