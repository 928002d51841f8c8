// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/geometry/pose.hpp"

namespace sonde {

/// The eigenvectors of a symmetric matrix in columns, by ascending eigenvalues, in closed form
/// (Smith, 1961): faster than iteration, and as exact as box trees need. For equal eigenvalues, any
/// valid vectors. The steps are those of Eigen's computeDirect, which calls the C library's
/// cosines.
Mat3 principal_axes(const Mat3& symmetric) noexcept;

}  // namespace sonde
