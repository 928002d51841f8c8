// SPDX-License-Identifier: GPL-3.0-or-later
// What nobody measured, for what is made of measurements.
#pragma once

#include "engine/study/identification/identification.hpp"

namespace sonde::test {

/// Translation alone; the rotations were refused.
inline Identification made_up_identification() {
  IdentifiedAxis axis;
  axis.axis = 1;
  axis.pulses = 16;
  axis.most = 2;
  axis.handle = {.inertia = {0.25, 0.24, 0.26},
                 .damping = {1.5, 1.4, 1.6},
                 .friction = {0.1, 0.05, 0.15},
                 .delay = {0.002, 0.0019, 0.0021},
                 .offset = 0.01,
                 .misfit = 0.034};
  axis.resolution = {1e-5, 0.9e-5, 1.1e-5};
  axis.has_steps = true;
  Identification out;
  out.sample_time = 1e-3;
  out.axes = {axis};
  out.refused = {{4, "it did not move"}};
  out.translation = IdentifiedKind{axis.handle.inertia, axis.handle.damping, axis.handle.friction,
                                   axis.resolution};
  out.delay = axis.handle.delay;
  return out;
}

}  // namespace sonde::test
