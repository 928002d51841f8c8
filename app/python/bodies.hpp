// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <string>

#include "app/python/initialised.hpp"
#include "engine/sonde.hpp"

namespace sonde::python {

/// A body with what it was made of, from which another process makes the same. (pybind11 keeps no
/// pointer to const.)
struct SharedBody {
  std::shared_ptr<const sonde::Body> body;
  BodyFacts facts;
  pybind11::tuple recipe;         ///< the name of what made it, and its arguments
  std::uint64_t fingerprint = 0;  ///< tells it from other bodies
};

void declare_body(pybind11::module_& module);

}  // namespace sonde::python

template <>
struct pybind11::detail::type_caster<sonde::python::SharedBody>
    : sonde::python::InitialisedCaster<sonde::python::SharedBody> {};
