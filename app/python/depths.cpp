// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/depths.hpp"

#include <stdexcept>
#include <string>

#include "engine/base/numbers.hpp"
#include "engine/scene/pose_numbers.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;

template <class Value>
py::array_t<Value> column(std::span<const Separation> rows, const auto& value_of) {
  py::array_t<Value> out(static_cast<py::ssize_t>(rows.size()));
  auto cells = out.template mutable_unchecked<1>();
  for (std::size_t i = 0; i < rows.size(); ++i)
    cells(static_cast<py::ssize_t>(i)) = static_cast<Value>(value_of(rows[i]));
  return out;
}

/// What a row that failed does not have is not a number.
py::array_t<double> found(std::span<const Separation> rows, const auto& value_of) {
  return column<double>(rows, [&](const Separation& s) {
    return s.status == Status::failed ? no_number : value_of(s);
  });
}

py::array_t<double> separated_poses(std::span<const Separation> rows) {
  py::array_t<double> out({static_cast<py::ssize_t>(rows.size()), py::ssize_t{7}});
  auto cells = out.mutable_unchecked<2>();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [q, p] = rows[i].separated;
    const std::array<double, 7> numbers{p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
    const bool failed = rows[i].status == Status::failed;
    for (std::size_t j = 0; j < 7; ++j)
      cells(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) =
          failed ? no_number : numbers[j];
  }
  return out;
}

}  // namespace

Depths depths_of(std::span<const Separation> rows) {
  py::list status;
  std::vector<const char*> reason;
  for (const Separation& s : rows) {
    status.append(name_of(s.status));
    reason.push_back(s.status == Status::failed ? s.reason : "");
  }
  return {
      .status = py::module_::import("numpy").attr("array")(status, "U11").cast<py::array>(),
      .reason = std::move(reason),
      .depth = found(rows, [](const Separation& s) { return s.depth; }),
      .sigma = found(rows, [](const Separation& s) { return s.sigma; }),
      .pose = separated_poses(rows),
      .lower_bound =
          found(rows, [](const Separation& s) { return s.lower_bound.value_or(no_number); }),
      .residual = found(rows, [](const Separation& s) { return s.residual; }),
      .contacts = column<std::int64_t>(
          rows,
          [](const Separation& s) { return s.status == Status::failed ? 0 : s.clusters.size; }),
      .iterations = column<std::int64_t>(rows, [](const Separation& s) { return s.iterations; }),
      .converged = column<bool>(rows, [](const Separation& s) { return s.converged; }),
      .jumped = column<bool>(rows, [](const Separation& s) { return s.jumped; }),
  };
}

std::vector<Pose> poses_of(const Numbers& numbers) {
  const bool one = numbers.ndim() == 1;
  if ((!one && numbers.ndim() != 2) || numbers.shape(one ? 0 : 1) != 7)
    throw std::invalid_argument("poses must be of shape (7,) or (n, 7): px,py,pz,qw,qx,qy,qz");
  const auto rows = static_cast<std::size_t>(one ? 1 : numbers.shape(0));
  std::vector<Pose> poses;
  poses.reserve(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::span<const double, 7> row(numbers.data() + 7 * i, 7);
    try {
      poses.push_back(pose_of_numbers(row));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("pose " + std::to_string(i) + ": " + error.what());
    }
  }
  return poses;
}

}  // namespace sonde::python
