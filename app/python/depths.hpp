// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/python/initialised.hpp"
#include "app/python/pair_mark.hpp"
#include "engine/sonde.hpp"

namespace sonde::python {

/// What is told of a pose: the columns of `sonde query`.
struct DepthRow {
  Status status = Status::failed;
  std::string reason;
  double depth = 0, sigma = 0, lower_bound = 0, residual = 0, clearance = 0, within = 0;
  std::array<double, 7> pose{}, device{};
  std::int64_t contacts = 0, iterations = 0;
  bool converged = false, jumped = false, late = false;
};
/// One contact that holds a separated pose.
struct ContactRow {
  std::int64_t row = 0;  ///< the number of its pose
  std::array<double, 3> point{}, normal{};
  double multiplier = 0;
};

/// The result of a pose; the row of its contacts is not said yet.
struct PoseResult {
  PoseResult() = default;
  // NOLINTBEGIN(google-explicit-constructor): what is kept of these
  PoseResult(const Separation& separation);
  /// With what it claims, and whether it was late.
  PoseResult(const Answer& answer);
  // NOLINTEND(google-explicit-constructor)
  DepthRow row;
  std::vector<ContactRow> contacts;
};

/// The results of many poses, one row each.
struct Depths {
  std::vector<DepthRow> rows;
  std::vector<ContactRow> contacts;  ///< in the order of their rows
  PairMark pair;
  /// The arrays that were asked for, by name: of few poses making all takes longer than a query.
  std::map<std::string_view, pybind11::object> arrays;
};
Depths depths_of(const std::vector<PoseResult>& results, const PairMark& pair);

void declare_depths(pybind11::module_& module);

}  // namespace sonde::python

template <>
struct pybind11::detail::type_caster<sonde::python::Depths>
    : sonde::python::InitialisedCaster<sonde::python::Depths> {};
