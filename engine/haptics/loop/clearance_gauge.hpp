// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// The room between the bodies at one device pose, from triangles alone, in the fixed body's mesh
/// frame, m.
struct GaugedClearance {
  Pose device;                   ///< X_FM that it is of
  double distance = 0;           ///< the least; 0 where the bodies overlap
  Vec3 on_probe = Vec3::Zero();  ///< where it is taken
  Vec3 on_fixed = Vec3::Zero();
};

/// One continuous quantity: the room where the probe is free (as measured last, the probe being
/// near there), minus the depth where it is held; none where neither is known.
std::optional<double> signed_clearance(const Separation& separation,
                                       const GaugedClearance* measured);

/// Measures the clearance of the newest requested pose, in a thread of its own. From a pose near
/// the last one it takes microseconds to milliseconds, from any other one more.
class ClearanceGauge {
 public:
  explicit ClearanceGauge(const Pair& pair);
  ~ClearanceGauge();
  ClearanceGauge(const ClearanceGauge&) = delete;
  ClearanceGauge& operator=(const ClearanceGauge&) = delete;

  /// The clearance at that pose, if it is there within so long; else the newest there is, of
  /// another pose, and this one follows. None before the first.
  std::optional<GaugedClearance> at(const Pose& X_FM, std::chrono::microseconds patience);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sonde
