// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/pose_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "engine/queries/pose_numbers.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::ui {
namespace {

constexpr std::string_view header = "px,py,pz,qw,qx,qy,qz";
constexpr std::string_view between = " \t\r\n,;[]()";

}  // namespace

std::string pose_text(const Pose& pose) {
  std::string text(header);
  char before = '\n';
  for (const double x :
       {pose.p.x(), pose.p.y(), pose.p.z(), pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()}) {
    text += before + number_text(x, 17);
    before = ',';
  }
  return text + '\n';
}

Pose pose_in(std::string_view text) {
  if (const std::size_t at = text.find(header); at != text.npos)
    text.remove_prefix(at + header.size());
  std::array<double, 7> numbers{};
  std::size_t count = 0;
  while (true) {
    const std::size_t begin = text.find_first_not_of(between);
    if (begin == text.npos) break;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(between));
    const auto number = parse_number(word);
    if (!number)
      throw std::invalid_argument("\"" + std::string(word.substr(0, 40)) + "\" is no number");
    if (count < numbers.size()) numbers.at(count) = *number;
    ++count;
    text.remove_prefix(word.size());
  }
  if (count != numbers.size())
    throw std::invalid_argument("a pose has 7 numbers, px, py, pz, qw, qx, qy, qz; there are " +
                                std::to_string(count));
  return pose_of_numbers(numbers);
}

Vec3 roll_pitch_yaw(const Quat& q) {
  const Mat3 R = q.normalized().toRotationMatrix();
  const double pitch = std::asin(std::clamp(-R(2, 0), -1.0, 1.0));
  // Straight up or down, roll and yaw are one turn: all of it is called yaw.
  if (std::hypot(R(2, 1), R(2, 2)) < 1e-9) return {0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Quat of_roll_pitch_yaw(const Vec3& angles) {
  return Quat(Eigen::AngleAxisd(angles.z(), Vec3::UnitZ()) *
              Eigen::AngleAxisd(angles.y(), Vec3::UnitY()) *
              Eigen::AngleAxisd(angles.x(), Vec3::UnitX()));
}

}  // namespace sonde::ui
