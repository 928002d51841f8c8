// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace sonde::python {

/// Declares Pair, the queries of it, depth() and Follower.
void declare_pair(pybind11::module_& module);

}  // namespace sonde::python
