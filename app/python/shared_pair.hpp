// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "app/python/bodies.hpp"
#include "app/python/pair_mark.hpp"
#include "engine/sonde.hpp"

namespace sonde::python {

/// Two bodies, with what is computed once for both.
struct SharedPair {
  SharedBody probe, fixed;
  Pair pair;
  PairMark mark() const { return {probe.fingerprint, fixed.fingerprint}; }
};

/// The class that holds it, of which each file declares its part.
using PairClass = pybind11::class_<SharedPair>;

}  // namespace sonde::python

template <>
struct pybind11::detail::type_caster<sonde::python::SharedPair>
    : sonde::python::InitialisedCaster<sonde::python::SharedPair> {};
