// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <span>
#include <string>
#include <vector>

#include "app/python/initialised.hpp"
#include "engine/sonde.hpp"

namespace sonde::python {

/// The results of many poses as arrays, one row each: the columns of `sonde query`; and one row for
/// each contact that holds a separated pose.
struct Depths {
  pybind11::array status;  ///< "separated", "penetrating" or "failed"
  std::vector<std::string> reason;
  pybind11::array_t<double> depth, sigma, pose, device, lower_bound, residual, clearance, within;
  pybind11::array_t<std::int64_t> contacts, iterations;
  pybind11::array_t<bool> converged, jumped, late;
  pybind11::array_t<std::int64_t> contact_row;
  pybind11::array_t<double> contact_point, contact_normal, contact_multiplier;
};
Depths depths_of(std::span<const Separation> separations);
/// With what each claims, and whether it was late.
Depths depths_of(std::span<const Answer> answers);

/// Declares Depths, and Separation, the result of one pose.
void declare_depths(pybind11::module_& module);

}  // namespace sonde::python

template <>
struct pybind11::detail::type_caster<sonde::python::Depths>
    : sonde::python::InitialisedCaster<sonde::python::Depths> {};
template <>
struct pybind11::detail::type_caster<sonde::Separation>
    : sonde::python::InitialisedCaster<sonde::Separation> {};
