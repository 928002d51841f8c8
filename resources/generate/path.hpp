// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde::generate {

/// A device path through key poses, as a hand would move: quintic from key to key, with continuous
/// velocity and acceleration, at rest at both ends.
class Path {
 public:
  /// Starts at rest: position in metres, rotation vector in degrees about the axes of the fixed
  /// body (a turn of more than half a circle is simply a longer vector).
  Path(const Vec3& position, const Vec3& turn_degrees);

  /// Passes through a pose `seconds` after the last key, without stopping.
  Path& via(double seconds, const Vec3& position, const Vec3& turn_degrees);
  /// Comes to rest at a pose.
  Path& rest(double seconds, const Vec3& position, const Vec3& turn_degrees);
  /// Stays at the last pose.
  Path& hold(double seconds);
  /// Goes back to where the path began and rests there.
  Path& home(double seconds);

  double duration() const { return keys_.back().t; }
  Pose at(double t) const;

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  struct Key {
    double t = 0;
    Vec6 x = Vec6::Zero();  ///< position (m), rotation vector (rad)
    bool rests = false;
  };
  Vec6 velocity(std::size_t key) const;
  std::vector<Key> keys_;
};

}  // namespace sonde::generate
