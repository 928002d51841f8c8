// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace sonde::python {

/// Takes only objects whose __init__ (or __setstate__) has run. Of others, those of
/// Pair.__new__(Pair), pybind11 would hand on memory that nothing was written to.
template <class T>
struct InitialisedCaster : pybind11::detail::type_caster_base<T> {
  bool load(pybind11::handle given, bool convert) {
    const auto* type = this->typeinfo;
    if (type && given && PyObject_TypeCheck(given.ptr(), type->type)) {
      auto* object = reinterpret_cast<pybind11::detail::instance*>(given.ptr());
      const auto held = object->get_value_and_holder(type, false);
      if (held.inst && held.value_ptr() == nullptr)
        throw pybind11::type_error("sonde." +
                                   pybind11::handle(reinterpret_cast<PyObject*>(type->type))
                                       .attr("__name__")
                                       .cast<std::string>() +
                                   ".__init__ was not called");
    }
    return pybind11::detail::type_caster_base<T>::load(given, convert);
  }
};

}  // namespace sonde::python
