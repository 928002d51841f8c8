// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled part of the Python module: bodies, pairs, depths and followers over NumPy arrays.
// Long work is done with the GIL released; depth() is what `sonde query` does, to the bit. It is
// written over the public face, engine/sonde.hpp, alone, but for what reads poses and shares out
// work.

#include <pybind11/pybind11.h>

#include "app/python/bodies.hpp"
#include "app/python/depths.hpp"
#include "app/python/pairs.hpp"
#include "app/python/separations.hpp"

PYBIND11_MODULE(_sonde, module) {
  using namespace sonde::python;
  namespace py = pybind11;
  module.doc() = "Penetration depth of two polygon soups.";
  module.attr("__version__") = SONDE_VERSION;
  py::register_exception<sonde::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Why the input cannot be a body or cannot be read; names the file and the line.";
  py::register_exception<sonde::Cancelled>(module, "Cancelled", PyExc_RuntimeError).doc() =
      "The progress function ended the work; nothing was changed.";
  declare_body(module);
  declare_depths(module);
  declare_separation(module);
  declare_pair(module);
}
