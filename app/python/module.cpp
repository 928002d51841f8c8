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

namespace {

namespace py = pybind11;

/// Pickles and copies of whatever protocol by __getstate__, as protocol 2 has it: before that,
/// Python makes an object that is not of the class, at which pybind11 ends the program.
void reduce_by_state(const py::object& declared) {
  const py::object made = py::module_::import("copyreg").attr("__newobj__");
  const auto reduced = [made](const py::object& self) {
    return py::make_tuple(made, py::make_tuple(py::type::of(self)), self.attr("__getstate__")());
  };
  declared.attr("__reduce__") = py::cpp_function(reduced, py::is_method(declared));
}

void refuse_to_reduce(const py::object& declared) {
  const auto refused = [](const py::object&) -> py::object {
    throw py::type_error("a Follower cannot be pickled: copy() goes on from the same state");
  };
  declared.attr("__reduce__") = py::cpp_function(refused, py::is_method(declared));
}

}  // namespace

PYBIND11_MODULE(_sonde, module) {
  using namespace sonde::python;
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
  for (const char* name : {"Body", "Pair", "Depths", "Separation"})
    reduce_by_state(module.attr(name));
  refuse_to_reduce(module.attr("Follower"));
}
