// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <vector>

#include "engine/sonde.hpp"

namespace sonde::python {

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// For row i of long work on arrays that is done with the interpreter's lock: now and then throws
/// what Ctrl-C raised.
void heed_interrupts(std::size_t i);

/// An array of doubles, whatever real numbers it was made of. Throws std::invalid_argument, which
/// names the argument, where it is of no real numbers.
Numbers numbers_in(const pybind11::object& given, const char* what);

/// Poses as they come from Python.
struct Poses {
  std::vector<Pose> rows;
  bool one = false;  ///< a single pose, not an array of them
};

/// Poses px,py,pz,qw,qx,qy,qz, one (7,) or many (n, 7), or matrices, (4, 4) or (n, 4, 4); of any
/// real type, contiguous or not. Rotations are made unit as in a file of poses. `what`: the
/// argument's name. Throws std::invalid_argument naming it, where the shape or the type is another,
/// a number is not finite, or a rotation is none (to 1e-3).
Poses poses_of(const pybind11::object& given, const char* what = "poses");

/// The one pose that is given, (7,) or (4, 4); errors as above, and where they are more.
Pose pose_of(const pybind11::object& given);

/// Points or directions, one (3,) or many (n, 3); errors as above.
struct Points {
  std::vector<Vec3> rows;
  bool one = false;
};
Points points_of(const pybind11::object& given, const char* what);

/// Rows of numbers as an array: of shape (n,) for one column, (n, columns) for more.
pybind11::array_t<double> rows_of(std::size_t rows, std::size_t columns, const auto& value_of) {
  std::vector<pybind11::ssize_t> shape{static_cast<pybind11::ssize_t>(rows)};
  if (columns > 1) shape.push_back(static_cast<pybind11::ssize_t>(columns));
  pybind11::array_t<double> out(shape);
  double* to = out.mutable_data();
  for (std::size_t i = 0; i < rows; ++i) {
    heed_interrupts(i);
    for (std::size_t j = 0; j < columns; ++j) *to++ = value_of(i, j);
  }
  return out;
}
/// px,py,pz,qw,qx,qy,qz.
std::array<double, 7> numbers_of(const Pose& pose);

}  // namespace sonde::python
