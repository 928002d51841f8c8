// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/wrenches.hpp"

#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/depths.hpp"
#include "app/python/every_row.hpp"
#include "app/python/poses.hpp"
#include "app/python/separations.hpp"
#include "app/python/words.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr Coupling gains;  // what is used where none are given

/// What a wrench depends on: the status and both poses.
Separation of_row(const DepthRow& row) {
  const auto pose = [](const std::array<double, 7>& n) {
    return Pose{Quat(n[3], n[4], n[5], n[6]), Vec3(n[0], n[1], n[2])};
  };
  Separation out;
  out.status = row.status;
  out.device = pose(row.device);
  out.separated = pose(row.pose);
  return out;
}

/// The numbers of another pair's result would look like any.
void need_result_of(const SharedPair& pair, const PairMark& mark, const std::string& name = "of") {
  if (mark != pair.mark())
    throw std::invalid_argument(name + " must be a result of this pair; it is one of other bodies");
}

py::array_t<double> array_of(const std::vector<Wrench>& felt) {
  return rows_of(felt.size(), 6, [&](std::size_t i, std::size_t j) {
    const auto axis = static_cast<Eigen::Index>(j % 3);
    return j < 3 ? felt[i].force[axis] : felt[i].torque[axis];
  });
}

void need_gain(const char* name, double given) {
  if (!std::isfinite(given) || given < 0)
    throw std::invalid_argument(std::string(name) + " must be finite, 0 or more");
}
void need_limit(const char* name, double given) {
  if (!(given >= 0)) throw std::invalid_argument(std::string(name) + " must be 0 or more");
}

/// With the damping of the classic and of the damped mode, if there is a separation before.
Wrench wrench_of(const SharedPair& pair, const Found& found, const Coupling& coupling,
                 const py::object& before, const std::optional<double>& dt) {
  if (before.is_none()) return wrench(pair.pair, found.separation, coupling);
  if (!py::isinstance<Found>(before)) throw std::invalid_argument("before must be a Separation");
  const auto& last = before.cast<const Found&>();
  need_result_of(pair, last.pair, "before");
  return wrench(pair.pair, found.separation, last.separation, *dt, coupling);
}

/// Whether a separation before and the time since are given: both or neither.
bool has_rates(const py::object& before, const std::optional<double>& dt) {
  if (before.is_none() != !dt) throw std::invalid_argument("before and dt are given together");
  if (dt && !(std::isfinite(*dt) && *dt > 0))
    throw std::invalid_argument("dt must be finite, above 0");
  return dt.has_value();
}

/// The wrench of rows of Depths: of their poses alone, as the coupling does without damping.
py::array_t<double> pair_wrench(const SharedPair& pair, const py::object& of,
                                Argument<"k", double> k, const Argument<"mode", std::string>& mode,
                                Argument<"k_t", double> k_t, Argument<"k_r", double> k_r,
                                Argument<"max_force", double> max_force,
                                Argument<"max_torque", double> max_torque,
                                Argument<"b_t", double> b_t, Argument<"b_r", double> b_r,
                                const py::object& before,
                                const Argument<"dt", std::optional<double>>& dt) {
  Coupling coupling;
  coupling.mode = chosen<Coupling::Mode>("mode", mode,
                                         {{"object", Coupling::Mode::object},
                                          {"classic", Coupling::Mode::classic},
                                          {"damped", Coupling::Mode::damped}});
  coupling.k = k, coupling.k_t = k_t, coupling.k_r = k_r;
  coupling.b_t = b_t, coupling.b_r = b_r;
  coupling.max_force = max_force, coupling.max_torque = max_torque;
  need_gain("k", k);
  need_gain("k_t", k_t);
  need_gain("k_r", k_r);
  need_gain("b_t", b_t);
  need_gain("b_r", b_r);
  need_limit("max_force", max_force);
  need_limit("max_torque", max_torque);
  const bool damps = has_rates(before, dt.value);
  if (py::isinstance<Found>(of)) {
    const auto& found = of.cast<const Found&>();
    need_result_of(pair, found.pair);
    return array_of({wrench_of(pair, found, coupling, before, dt.value)});
  }
  if (damps) throw std::invalid_argument("with before, of must be a Separation");
  if (!py::isinstance<Depths>(of)) throw std::invalid_argument("of must be Depths or a Separation");
  const auto& depths = of.cast<const Depths&>();
  need_result_of(pair, depths.pair);
  std::vector<Wrench> felt(depths.rows.size());
  for_every_row(felt.size(), Takes::microseconds, [&](std::size_t i) {
    felt[i] = wrench(pair.pair, of_row(depths.rows[i]), coupling);
  });
  return array_of(felt);
}

py::array_t<double> array_of(const WrenchDerivative::Matrix& matrix) {
  return rows_of(6, 6, [&](std::size_t i, std::size_t j) {
    return matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  });
}

/// d(depth), d(wrench) on either side, and which sides there are.
py::tuple pair_derivative(const SharedPair& pair, const py::object& of) {
  if (!py::isinstance<Found>(of)) throw std::invalid_argument("of must be a Separation");
  const auto& found = of.cast<const Found&>();
  need_result_of(pair, found.pair);
  const WrenchDerivative d = wrench_derivative(pair.pair, found.separation, Neighbours::all);
  const char* sides = d.sides == WrenchDerivative::Sides::all   ? "all"
                      : d.sides == WrenchDerivative::Sides::two ? "two"
                                                                : "none";
  return py::make_tuple(py::array_t<double>(6, d.d_depth.data()), array_of(d.d_wrench),
                        array_of(d.d_wrench_held), sides);
}

/// The values (3,) and the directions (3, 3), a row each.
py::tuple arrays_of(const std::array<PrincipalStiffness, 3>& three) {
  return py::make_tuple(rows_of(3, 1, [&](std::size_t i, std::size_t) { return three[i].value; }),
                        rows_of(3, 3, [&](std::size_t i, std::size_t j) {
                          return three[i].direction[static_cast<Eigen::Index>(j)];
                        }));
}

py::tuple principal_of(const py::object& given, Argument<"k", double> k) {
  const Numbers d_wrench = numbers_in(given, "d_wrench");
  if (d_wrench.ndim() != 2 || d_wrench.shape(0) != 6 || d_wrench.shape(1) != 6)
    throw std::invalid_argument("d_wrench must be of shape (6, 6)");
  WrenchDerivative derivative;
  for (Eigen::Index i = 0; i < 6; ++i)
    for (Eigen::Index j = 0; j < 6; ++j) derivative.d_wrench(i, j) = d_wrench.at(i, j);
  if (!derivative.d_wrench.allFinite()) throw std::invalid_argument("d_wrench must be finite");
  if (!std::isfinite(k.value)) throw std::invalid_argument("k must be finite");
  const PrincipalStiffnesses found = principal_stiffnesses(derivative, k);
  return py::tuple(arrays_of(found.translation) + arrays_of(found.rotation));
}

}  // namespace

void declare_wrenches(py::module_& module, PairClass& pair) {
  pair.def(
          "wrench", &pair_wrench, "of"_a, "k"_a = gains.k, "mode"_a = "object", "k_t"_a = gains.k_t,
          "k_r"_a = gains.k_r, "max_force"_a = 1e30, "max_torque"_a = 1e30, "b_t"_a = gains.b_t,
          "b_r"_a = gains.b_r, "before"_a = py::none(), "dt"_a = py::none(),
          "Force (N) and torque (N m, about the probe's centre of mass) on the hand, in the fixed\n"
          "frame, (n, 6), of Depths or a Separation of this pair. mode \"object\": k in N/m;\n"
          "\"classic\": k_t in N/m and k_r in N m/rad; \"damped\": k. With the Separation of this\n"
          "pair that was `before`, `dt` s ago, the dampers are added: b_t in N s/m, of both\n"
          "\"classic\" and \"damped\" (there of separations that may turn), and b_r in\n"
          "N m s/rad, of \"classic\".")
      .def("derivative", &pair_derivative, "of"_a,
           "How the depth (6,) and the wrench (6, 6), at k = 1, of a Separation of this pair\n"
           "change with its pose: by a displacement of the probe's centre of mass, m, and a\n"
           "rotation vector, rad, in the fixed frame. Then the wrench's on the other side, and\n"
           "\"all\" where both are one, \"two\" where contacts begin or end at this pose, or\n"
           "\"none\" where there is no derivative.");
  module.def("wrench", &pair_wrench, "pair"_a, "of"_a, "k"_a = gains.k, "mode"_a = "object",
             "k_t"_a = gains.k_t, "k_r"_a = gains.k_r, "max_force"_a = 1e30, "max_torque"_a = 1e30,
             "b_t"_a = gains.b_t, "b_r"_a = gains.b_r, "before"_a = py::none(), "dt"_a = py::none(),
             "As Pair.wrench.");
  module.def("derivative", &pair_derivative, "pair"_a, "of"_a, "As Pair.derivative.");
  module.def(
      "principal_stiffnesses", &principal_of, "d_wrench"_a, "k"_a = gains.k,
      "The stiffness that the hand feels at a gain of k, N/m, in its principal directions, the\n"
      "largest first, of a (6, 6) that derivative() gave, of either side: of displacements (3,),\n"
      "N/m, along directions (3, 3), a row each, unit, in the fixed frame; and of turns about\n"
      "the centre of mass (3,), N m/rad, about directions (3, 3).");
}

}  // namespace sonde::python
