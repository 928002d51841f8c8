// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/poses.hpp"

#include <string_view>

#include "engine/queries/pose_numbers.hpp"
#include "engine/text/csv_rows.hpp"

namespace sonde {

namespace {

constexpr std::size_t most_pose_bytes = std::size_t{1} << 30;
constexpr std::string_view names[] = {"t", "px", "py", "pz", "qw", "qx", "qy", "qz"};

}  // namespace

std::vector<Pose> read_poses(const std::filesystem::path& file) {
  std::vector<Pose> poses;
  read_csv_rows(
      file, std::span(names).subspan(1), most_pose_bytes,
      [&](std::span<const double> row) { poses.push_back(pose_of_numbers(row.first<7>())); });
  return poses;
}

std::vector<Pose> read_poses_or_path(const std::filesystem::path& file) {
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
