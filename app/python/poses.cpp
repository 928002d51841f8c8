// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/poses.hpp"

#include <cmath>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>

#include "engine/queries/pose_matrix.hpp"
#include "engine/queries/pose_numbers.hpp"

namespace sonde::python {

namespace py = pybind11;

Numbers numbers_in(const py::object& given, const char* what) {
  // NumPy would leave out the mask without a word.
  if (std::strcmp(Py_TYPE(given.ptr())->tp_name, "MaskedArray") == 0)
    throw std::invalid_argument(std::string(what) + " is a masked array: give its filled() values");
  if (py::isinstance<Numbers>(given)) return py::reinterpret_borrow<Numbers>(given);
  const py::array array(given);
  const char kind = array.dtype().kind();
  if (kind != 'f' && kind != 'i' && kind != 'u')
    throw std::invalid_argument(std::string(what) + " must be real numbers, not of type " +
                                py::str(array.dtype()).cast<std::string>());
  return Numbers(array);
}

void heed_interrupts(std::size_t i) {
  constexpr std::size_t some = 1 << 16;
  if (i % some == some - 1 && PyErr_CheckSignals() != 0) throw py::error_already_set();
}

Poses poses_of(const py::object& given, const char* what) {
  const Numbers numbers = numbers_in(given, what);
  const auto shape = [&](py::ssize_t i) { return i < numbers.ndim() ? numbers.shape(i) : 0; };
  const py::ssize_t dims = numbers.ndim();
  const bool matrices = (dims == 2 && shape(0) == 4 && shape(1) == 4) ||
                        (dims == 3 && shape(1) == 4 && shape(2) == 4);
  const bool rows = (dims == 1 && shape(0) == 7) || (dims == 2 && shape(1) == 7);
  if (!matrices && !rows)
    throw std::invalid_argument(std::string(what) +
                                " must be of shape (7,) or (n, 7): px,py,pz,qw,qx,qy,qz, or of "
                                "matrices, (4, 4) or (n, 4, 4)");
  Poses out;
  out.one = dims == (matrices ? 2 : 1);
  const auto count = static_cast<std::size_t>(out.one ? 1 : shape(0));
  const std::size_t step = matrices ? 16 : 7;
  out.rows.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* row = numbers.data() + step * i;
    heed_interrupts(i);
    try {
      out.rows.push_back(matrices ? pose_of_matrix(std::span<const double, 16>(row, 16))
                                  : pose_of_numbers(std::span<const double, 7>(row, 7)));
    } catch (const std::exception& error) {
      const std::string name = std::string(what) == "poses" ? "pose" : what;
      throw std::invalid_argument(name + " " + std::to_string(i) + ": " + error.what());
    }
  }
  return out;
}

Pose pose_of(const py::object& given) {
  const Poses poses = poses_of(given, "pose");
  if (!poses.one) throw std::invalid_argument("pose must be one, of shape (7,) or (4, 4)");
  return poses.rows[0];
}

Points points_of(const py::object& given, const char* what) {
  const Numbers numbers = numbers_in(given, what);
  Points out;
  out.one = numbers.ndim() == 1;
  if ((!out.one && numbers.ndim() != 2) || numbers.shape(out.one ? 0 : 1) != 3)
    throw std::invalid_argument(std::string(what) + " must be of shape (3,) or (n, 3)");
  const auto count = static_cast<std::size_t>(out.one ? 1 : numbers.shape(0));
  out.rows.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    heed_interrupts(i);
    out.rows.push_back(Eigen::Map<const Vec3>(numbers.data() + 3 * i));
  }
  return out;
}

std::array<double, 7> numbers_of(const Pose& pose) {
  const auto& [q, p] = pose;
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

}  // namespace sonde::python
