// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/separations.hpp"

#include <pybind11/stl.h>

#include <sstream>

#include "app/python/poses.hpp"
#include "app/python/separation_state.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;

using Class = py::class_<Found>;

/// A property that is a member.
template <class Value>
void declare(Class& found, const char* name, Value Separation::*member, const char* words) {
  found.def_property_readonly(
      name, [member](const Found& f) { return f.separation.*member; }, words);
}

void declare(Class& found, const char* name, Pose Separation::*member, const char* words) {
  found.def_property_readonly(
      name,
      [member](const Found& f) {
        return py::array_t<double>(7, numbers_of(f.separation.*member).data());
      },
      words);
}

/// Of each of its contacts, a row.
void declare_of_contacts(Class& found, const char* name, std::size_t columns,
                         double (*value)(const Contact&, Eigen::Index), const char* words) {
  found.def_property_readonly(
      name,
      [columns, value](const Found& f) {
        const ContactSet& all = f.separation.contacts;
        const bool held = f.separation.status == Status::penetrating;
        return rows_of(held ? static_cast<std::size_t>(all.size) : 0, columns,
                       [&](std::size_t i, std::size_t j) {
                         return value(all.items[i], static_cast<Eigen::Index>(j));
                       });
      },
      words);
}

std::string words_for(const Found& found) {
  const Separation& s = found.separation;
  std::ostringstream out;
  out << "<sonde.Separation " << name_of(s.status);
  if (s.status == Status::penetrating)
    out << ", " << s.depth << " m, " << s.contacts.size << " contacts";
  if (s.status == Status::failed) out << ": " << found.reason;
  out << ">";
  return out.str();
}

}  // namespace

void declare_separation(py::module_& module) {
  Class found(module, "Separation", "The result of one pose.");
  found
      .def_property_readonly(
          "status", [](const Found& f) { return name_of(f.separation.status); },
          "\"separated\", \"penetrating\" or \"failed\".")
      .def_property_readonly(
          "reason", [](const Found& f) { return f.reason; },
          "Why the pose failed; empty where it did not.")
      .def_property_readonly(
          "clearance",
          [](const Found& f) -> std::optional<double> {
            if (!f.separation.clearance) return std::nullopt;
            return f.separation.clearance->distance;
          },
          "Least distance of the bodies where they are apart and that was asked for, m; or None.")
      .def("__repr__", [](const Found& f) { return words_for(f); })
      .def(py::pickle([](const Found& f) { return state_of(f); }, &found_of));
  declare(found, "depth", &Separation::depth, "sqrt(PD_g), m.");
  declare(found, "sigma", &Separation::sigma, "The square of the depth, m^2.");
  declare(found, "pose", &Separation::separated, "The separated pose, (7,): px,py,pz,qw,qx,qy,qz.");
  declare(found, "device", &Separation::device, "The pose that was given, (7,).");
  declare(found, "lower_bound", &Separation::lower_bound,
          "Lower bound of the depth, m; None where there is none.");
  declare(found, "residual", &Separation::residual,
          "|y - J^T lambda| / |y|: distance from a local optimum.");
  declare(found, "iterations", &Separation::iterations, "Steps of the local optimiser.");
  declare(found, "converged", &Separation::converged, "False where the budget ran out first.");
  declare(found, "jumped", &Separation::jumped, "The force is not continuous here.");
  declare(found, "lagged", &Separation::lagged,
          "It jumped for no other reason than that it was behind and caught up.");
  declare_of_contacts(
      found, "contact_point", 3, [](const Contact& c, Eigen::Index j) { return c.on_fixed[j]; },
      "Points of the contacts, on the fixed body, in its mesh frame, (k, 3), m.");
  declare_of_contacts(
      found, "contact_normal", 3, [](const Contact& c, Eigen::Index j) { return c.normal[j]; },
      "Their normals, unit, from the fixed body to the probe, (k, 3).");
  declare_of_contacts(
      found, "contact_multiplier", 1, [](const Contact& c, Eigen::Index) { return c.multiplier; },
      "What each carries, m: times the stiffness it is a force, (k,).");
}

}  // namespace sonde::python
