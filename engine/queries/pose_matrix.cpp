// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/queries/pose_matrix.hpp"

#include <cmath>

#include "engine/base/round_to_nearest.hpp"

namespace sonde {

Pose pose_of_matrix(std::span<const double, 16> m) {
  const RoundToNearest round_to_nearest;
  Mat3 R;
  Vec3 p;
  for (int i = 0; i < 3; ++i) {
    const auto row = static_cast<std::size_t>(4 * i);
    for (int j = 0; j < 3; ++j) R(i, j) = m[row + static_cast<std::size_t>(j)];
    p[i] = m[row + 3];
  }
  if (!R.allFinite() || !p.allFinite()) throw InputError("a number of the matrix is not finite");
  const double last = std::abs(m[12]) + std::abs(m[13]) + std::abs(m[14]) + std::abs(m[15] - 1);
  if (!(last <= 1e-9)) throw InputError("the last row of the matrix is not 0, 0, 0, 1");
  const double off = (R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= 1e-3) || !(R.determinant() > 0))
    throw InputError(
        "the upper left of the matrix is no rotation: its columns must be square to each other, of "
        "length 1 and right-handed");
  return {Quat(R).normalized(), p};
}

}  // namespace sonde
