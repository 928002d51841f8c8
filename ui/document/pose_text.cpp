// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/pose_text.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "engine/queries/pose_numbers.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::ui {
namespace {

constexpr std::string_view header = "px,py,pz,qw,qx,qy,qz";
constexpr std::string_view between = " \t\r\n,;[]()=";
constexpr double unit_within = 1e-3;  // of a matrix that is no rotation quite, as of quaternions

/// What NumPy writes around numbers.
bool is_numpys(std::string_view word) {
  for (const std::string_view known : {"array", "np.array", "numpy.array", "np.asarray", "dtype",
                                       "float64", "float32", "float", "np.float64", "np.float32"})
    if (word == known) return true;
  return false;
}

std::vector<double> numbers_in(std::string_view text) {
  constexpr std::size_t most = 100;  // more is no pose, whatever it is
  std::vector<double> numbers;
  while (numbers.size() < most) {
    const std::size_t begin = text.find_first_not_of(between);
    if (begin == text.npos) break;
    text.remove_prefix(begin);
    const std::string_view word = text.substr(0, text.find_first_of(between));
    text.remove_prefix(word.size());
    if (is_numpys(word)) continue;
    const auto number = parse_number(word);
    if (!number)
      throw std::invalid_argument("\"" + std::string(word.substr(0, 40)) + "\" is no number");
    numbers.push_back(*number);
  }
  return numbers;
}

/// Of three or four rows of four; the rotation nearest to it.
Pose pose_of_matrix(const std::vector<double>& n) {
  Mat3 R;
  Vec3 p;
  for (std::size_t row = 0; row < 3; ++row) {
    const auto i = static_cast<Eigen::Index>(row);
    R.row(i) << n[4 * row], n[4 * row + 1], n[4 * row + 2];
    p[i] = n[4 * row + 3];
  }
  if (!R.allFinite() || !p.allFinite()) throw std::invalid_argument("a number is not finite");
  const bool last_row = n.size() == 12 || (n[12] == 0 && n[13] == 0 && n[14] == 0 && n[15] == 1);
  if (!last_row) throw std::invalid_argument("the last row of the matrix is not 0, 0, 0, 1");
  if (!((R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff() < unit_within))
    throw std::invalid_argument(
        "the matrix turns and does more: its columns are not of length 1 "
        "and square to each other");
  if (R.determinant() < 0) throw std::invalid_argument("the matrix mirrors");
  const Eigen::JacobiSVD<Mat3> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {Quat(Mat3(svd.matrixU() * svd.matrixV().transpose())).normalized(), p};
}

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

std::string matrix_text(const Pose& pose) {
  const Mat3 R = pose.q.normalized().toRotationMatrix();
  std::string text = "np.array([";
  for (int row = 0; row < 3; ++row) {
    text += row == 0 ? "[" : "          [";
    for (int column = 0; column < 3; ++column) text += number_text(R(row, column), 17) + ", ";
    text += number_text(pose.p[row], 17) + "],\n";
  }
  return text + "          [0, 0, 0, 1]])\n";
}

Pose pose_in(std::string_view text) {
  if (const std::size_t at = text.find(header); at != text.npos)
    text.remove_prefix(at + header.size());
  const std::vector<double> n = numbers_in(text);
  if (n.size() == 12 || n.size() == 16) return pose_of_matrix(n);
  std::array<double, 7> numbers{};
  if (n.size() != numbers.size())
    throw std::invalid_argument(
        "a pose has 7 numbers, px, py, pz, qw, qx, qy, qz, or the 16 of a matrix; there are " +
        std::to_string(n.size()));
  std::ranges::copy(n, numbers.begin());
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
