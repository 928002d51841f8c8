// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/scene/poses.hpp"

namespace sonde {

struct RowAgeOptions {
  Method method = Method::pdg;
  Budget budget;          ///< of the geometry, in each tick; its steps keep the bits the same
  double k = 500;         ///< N/m, of the object norm
  double rate_hz = 1000;  ///< of the servo
  double speed = 1;       ///< how many times faster than recorded the path is run
  std::vector<int> ages{0, 1, 2, 5, 10, 20};  ///< of the rows, ticks; zero or more
};

/// Of many values.
struct Spread {
  double median = 0, p99 = 0, largest = 0;
};

/// What rows of one age cost on one path, beside the loop in step.
struct RowAge {
  int age = 0;               ///< ticks
  int ticks = 0;             ///< in contact, there or in step, and compared
  int held_back = 0;         ///< of them, where the rows did not reach
  double probe_speed = 0;    ///< m/s: p99 over ticks of the fastest point of the probe
  double largest_force = 0;  ///< N, in step
  Spread force_error;        ///< |F − F in step|, N
  Spread torque_error;       ///< |τ − τ in step|, N·m
  Spread solve_us;           ///< processor time of the local problem; it and the next differ by run
  Spread refresh_us;         ///< processor time of the geometry
};

/// Runs the path with the geometry in step, and at each tick solves the rows of `age` ticks ago at
/// the device pose of now, with no thread and no clock. Ticks whose separated pose jumped since the
/// rows were made are left out of the errors: there, in step or not, the force is not continuous.
std::vector<RowAge> measure_row_age(const Pair& pair, std::span<const TimedPose> path,
                                    const RowAgeOptions& options);

}  // namespace sonde
