// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/wrenches.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/depths.hpp"
#include "app/python/poses.hpp"
#include "app/python/words.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

/// The wrench of rows of Depths: of their poses alone, as the coupling does without damping.
py::array_t<double> pair_wrench(const SharedPair& pair, const py::object& of,
                                Argument<"k", double> k, const Argument<"mode", std::string>& mode,
                                Argument<"k_t", double> k_t, Argument<"k_r", double> k_r,
                                Argument<"max_force", double> max_force,
                                Argument<"max_torque", double> max_torque) {
  Coupling coupling;
  coupling.mode = chosen<Coupling::Mode>(
      "mode", mode, {{"object", Coupling::Mode::object}, {"classic", Coupling::Mode::classic}});
  coupling.k = k, coupling.k_t = k_t, coupling.k_r = k_r;
  coupling.b_t = coupling.b_r = 0;
  coupling.max_force = max_force, coupling.max_torque = max_torque;
  for (const double x : {k.value, k_t.value, k_r.value})
    if (!std::isfinite(x) || x < 0)
      throw std::invalid_argument("a stiffness must be finite, 0 or more");
  for (const double x : {max_force.value, max_torque.value})
    if (!(x >= 0)) throw std::invalid_argument("a limit must be 0 or more");
  std::vector<Separation> rows;
  if (py::isinstance<Separation>(of)) {
    rows.push_back(of.cast<const Separation&>());
  } else if (py::isinstance<Depths>(of)) {
    const auto& depths = of.cast<const Depths&>();
    const auto status = depths.status.attr("tolist")().cast<std::vector<std::string>>();
    for (std::size_t i = 0; i < status.size(); ++i) {
      Separation s;
      s.status = status[i] == "penetrating" ? Status::penetrating
                 : status[i] == "separated" ? Status::separated
                                            : Status::failed;
      const auto pose = [&](const py::array_t<double>& all) {
        const double* n = all.data() + 7 * i;
        return Pose{Quat(n[3], n[4], n[5], n[6]), Vec3(n[0], n[1], n[2])};
      };
      s.device = pose(depths.device);
      s.separated = pose(depths.pose);
      rows.push_back(s);
    }
  } else {
    throw std::invalid_argument("of must be Depths or a Separation");
  }
  std::vector<Wrench> felt;
  felt.reserve(rows.size());
  for (const Separation& row : rows) felt.push_back(wrench(pair.pair, row, coupling));
  return rows_of(rows.size(), 6, [&](std::size_t i, std::size_t j) {
    const auto axis = static_cast<Eigen::Index>(j % 3);
    return j < 3 ? felt[i].force[axis] : felt[i].torque[axis];
  });
}

/// d(depth), d(wrench) on either side, and which sides there are.
py::tuple pair_derivative(const SharedPair& pair, const Separation& of) {
  const WrenchDerivative d = wrench_derivative(pair.pair, of, Neighbours::all);
  const auto matrix = [](const WrenchDerivative::Matrix& m) {
    return rows_of(6, 6, [&](std::size_t i, std::size_t j) {
      return m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    });
  };
  const char* sides = d.sides == WrenchDerivative::Sides::all   ? "all"
                      : d.sides == WrenchDerivative::Sides::two ? "two"
                                                                : "none";
  return py::make_tuple(py::array_t<double>(6, d.d_depth.data()), matrix(d.d_wrench),
                        matrix(d.d_wrench_held), sides);
}

}  // namespace

void declare_wrenches(py::module_& module, PairClass& pair) {
  pair.def(
          "wrench", &pair_wrench, "of"_a, "k"_a = 1000.0, "mode"_a = "object", "k_t"_a = 1000.0,
          "k_r"_a = 1.0, "max_force"_a = 1e30, "max_torque"_a = 1e30,
          "Force (N) and torque (N m, about the probe's centre of mass) on the hand, in the fixed\n"
          "frame, (n, 6), of Depths or a Separation of this pair. mode \"object\": k in N/m;\n"
          "\"classic\": k_t in N/m and k_r in N m/rad, without damping.")
      .def("derivative", &pair_derivative, "of"_a,
           "How the depth (6,) and the wrench (6, 6), at k = 1, of a Separation of this pair "
           "change\n"
           "with its pose: by a displacement of the probe's centre of mass, m, and a rotation\n"
           "vector, rad, in the fixed frame. Then the wrench's on the other side, and \"all\" "
           "where\n"
           "both are one, \"two\" where contacts begin or end at this pose, or \"none\" where "
           "there\n"
           "is no derivative.");
  module.def("wrench", &pair_wrench, "pair"_a, "of"_a, "k"_a = 1000.0, "mode"_a = "object",
             "k_t"_a = 1000.0, "k_r"_a = 1.0, "max_force"_a = 1e30, "max_torque"_a = 1e30,
             "As Pair.wrench.");
}

}  // namespace sonde::python
