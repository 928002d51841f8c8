// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/poses.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "engine/scene/pose_numbers.hpp"
#include "engine/text/csv_rows.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {

Pose pose_of_numbers(std::span<const double, 7> n) {
  for (const double x : n)
    if (!std::isfinite(x)) throw std::invalid_argument("a number of the pose is not finite");
  const Quat q(n[3], n[4], n[5], n[6]);
  const double length = q.norm();
  if (!(std::abs(length - 1) <= 1e-3))
    throw std::invalid_argument("the quaternion qw,qx,qy,qz has length " + number_text(length, 6) +
                                "; it must be 1 within 0.001");
  return {q.normalized(), Vec3(n[0], n[1], n[2])};
}

namespace {

constexpr std::size_t most_pose_bytes = std::size_t{1} << 30;
constexpr std::string_view names[] = {"t", "px", "py", "pz", "qw", "qx", "qy", "qz"};

}  // namespace

std::vector<Pose> read_poses(const std::filesystem::path& file) {
  std::vector<Pose> poses;
  read_csv_rows(
      file, std::span(names).subspan(1), names, most_pose_bytes,
      [&](std::span<const double> row) { poses.push_back(pose_of_numbers(row.last<7>())); });
  return poses;
}

std::vector<TimedPose> read_trajectory(const std::filesystem::path& file) {
  std::vector<TimedPose> path;
  read_csv_rows(file, names, most_pose_bytes, [&](std::span<const double> row) {
    if (!path.empty()) expect_later(row[0], path.back().t);
    path.push_back({row[0], pose_of_numbers(row.last<7>())});
  });
  return path;
}

}  // namespace sonde
