// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/python/shared_pair.hpp"

namespace sonde::python {

/// Declares Pair.wrench, wrench and Pair.derivative.
void declare_wrenches(pybind11::module_& module, PairClass& pair);

}  // namespace sonde::python
