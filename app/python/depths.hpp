// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <span>
#include <vector>

#include "engine/sonde.hpp"

namespace sonde::python {

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// The results of many poses as arrays, one row each: the columns of `sonde query`.
struct Depths {
  pybind11::array status;  ///< "separated", "penetrating" or "failed"
  std::vector<const char*> reason;
  pybind11::array_t<double> depth, sigma, pose, lower_bound, residual;
  pybind11::array_t<std::int64_t> contacts, iterations;
  pybind11::array_t<bool> converged, jumped;
};
Depths depths_of(std::span<const Separation> separations);

/// Poses px,py,pz,qw,qx,qy,qz, one (7,) or many (n, 7), with quaternions made unit as in a file of
/// poses. Throws std::invalid_argument.
std::vector<Pose> poses_of(const Numbers& numbers);

}  // namespace sonde::python
