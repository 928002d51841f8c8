// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// The distance of the bodies' triangles at one device pose, in the fixed body's mesh frame, m.
struct GaugedClearance {
  Pose device;                   ///< X_FM for which it was measured
  double distance = 0;           ///< least distance; 0 if the triangles meet
  Vec3 on_probe = Vec3::Zero();  ///< the closest points
  Vec3 on_fixed = Vec3::Zero();
};

/// One continuous quantity: the clearance where the probe is free (the last measured one, at a pose
/// near by), or minus the depth where it is in contact; none if neither is known.
std::optional<double> signed_clearance(const Separation& separation,
                                       const GaugedClearance* measured);

/// Measures the clearance of the newest requested pose in its own thread. It takes microseconds to
/// milliseconds from a pose near the last one, and longer from any other.
class ClearanceGauge {
 public:
  explicit ClearanceGauge(const Pair& pair);
  ~ClearanceGauge();
  ClearanceGauge(const ClearanceGauge&) = delete;
  ClearanceGauge& operator=(const ClearanceGauge&) = delete;

  /// The clearance at that pose, if it is ready within `patience`; otherwise the newest available
  /// one, of another pose, and this one is measured next. None before the first.
  std::optional<GaugedClearance> at(const Pose& X_FM, std::chrono::microseconds patience);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
