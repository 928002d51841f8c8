// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "app/python/separations.hpp"

namespace sonde::python {

/// For pickle: all numbers of a result, and the same of them again.
pybind11::tuple state_of(const Found& found);
Found found_of(const pybind11::tuple& state);

}  // namespace sonde::python
