// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/path.hpp"

#include <algorithm>
#include <numbers>

namespace sonde::generate {
namespace {

Eigen::Matrix<double, 6, 1> key_vector(const Vec3& position, const Vec3& turn_degrees) {
  Eigen::Matrix<double, 6, 1> x;
  x << position, turn_degrees * (std::numbers::pi / 180);
  return x;
}

}  // namespace

Path::Path(const Vec3& position, const Vec3& turn_degrees) {
  keys_.push_back({0, key_vector(position, turn_degrees), true});
}

Path& Path::via(double seconds, const Vec3& position, const Vec3& turn_degrees) {
  keys_.push_back({duration() + seconds, key_vector(position, turn_degrees), false});
  return *this;
}

Path& Path::rest(double seconds, const Vec3& position, const Vec3& turn_degrees) {
  keys_.push_back({duration() + seconds, key_vector(position, turn_degrees), true});
  return *this;
}

Path& Path::hold(double seconds) {
  keys_.back().rests = true;
  keys_.push_back({duration() + seconds, keys_.back().x, true});
  return *this;
}

Path& Path::home(double seconds) {
  keys_.push_back({duration() + seconds, keys_.front().x, true});
  return *this;
}

Path::Vec6 Path::velocity(std::size_t key) const {
  if (keys_[key].rests) return Vec6::Zero();
  const Key& before = keys_[key - 1];
  const Key& after = keys_[key + 1];
  return (after.x - before.x) / (after.t - before.t);
}

Pose Path::at(double t) const {
  std::size_t i = 0;
  while (i + 2 < keys_.size() && keys_[i + 1].t <= t) ++i;
  const Key& a = keys_[i];
  const Key& b = keys_[i + 1];
  const double h = b.t - a.t;
  const double s = std::clamp((t - a.t) / h, 0.0, 1.0);
  const double s3 = s * s * s;
  // Quintic Hermite with no acceleration at the keys: joins them with two continuous derivatives.
  const double blend = s3 * (s * (6 * s - 15) + 10);
  const double leave = s + s3 * (s * (8 - 3 * s) - 6);
  const double arrive = s3 * (s * (7 - 3 * s) - 4);
  const Vec6 x = a.x + blend * (b.x - a.x) + h * (leave * velocity(i) + arrive * velocity(i + 1));
  const Vec3 turn = x.tail<3>();
  const double angle = turn.norm();
  Pose pose;
  pose.p = x.head<3>();
  if (angle > 0) pose.q = Quat(Eigen::AngleAxisd(angle, turn / angle));
  return pose;
}

}  // namespace sonde::generate
