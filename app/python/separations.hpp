// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "app/python/initialised.hpp"
#include "app/python/pair_mark.hpp"
#include "engine/sonde.hpp"

namespace sonde::python {

/// The result of one pose, which is Separation in Python.
struct Found {
  Found(const Separation& result, const PairMark& of)
      : separation(result),
        pair(of),
        reason(result.status == Status::failed ? result.reason : "") {}
  Separation separation;
  PairMark pair;
  std::string reason;  ///< why it failed; separation.reason may be empty instead
};

void declare_separation(pybind11::module_& module);

}  // namespace sonde::python

template <>
struct pybind11::detail::type_caster<sonde::python::Found>
    : sonde::python::InitialisedCaster<sonde::python::Found> {};
