// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/depths.hpp"

#include <pybind11/stl.h>

#include <limits>
#include <sstream>

#include "app/python/poses.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

template <class Value>
py::array_t<Value> column(std::span<const Separation> rows, const auto& value_of) {
  py::array_t<Value> out(static_cast<py::ssize_t>(rows.size()));
  Value* to = out.mutable_data();
  for (const Separation& row : rows) *to++ = static_cast<Value>(value_of(row));
  return out;
}

/// What a row that failed does not have is not a number.
py::array_t<double> found(std::span<const Separation> rows, const auto& value_of) {
  return column<double>(
      rows, [&](const Separation& s) { return s.status == Status::failed ? none : value_of(s); });
}

py::array_t<double> poses_in(std::span<const Separation> rows, Pose Separation::*member,
                             bool failed_too) {
  return rows_of(rows.size(), 7, [&](std::size_t i, std::size_t j) {
    const bool failed = !failed_too && rows[i].status == Status::failed;
    return failed ? none : numbers_of(rows[i].*member)[j];
  });
}

/// Contacts of all rows, one after the other.
struct Contacts {
  std::vector<std::size_t> row;
  std::vector<Contact> contact;
  explicit Contacts(std::span<const Separation> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (rows[i].status == Status::penetrating)
        for (const Contact& c : rows[i].contacts) row.push_back(i), contact.push_back(c);
  }
  py::array_t<double> vectors(Vec3 Contact::*member) const {
    return rows_of(contact.size(), 3, [&](std::size_t i, std::size_t j) {
      return (contact[i].*member)[static_cast<Eigen::Index>(j)];
    });
  }
  py::array_t<double> multipliers() const {
    return rows_of(contact.size(), 1,
                   [&](std::size_t i, std::size_t) { return contact[i].multiplier; });
  }
};

py::array_t<double> seven(const Pose& pose) {
  return py::array_t<double>(7, numbers_of(pose).data());
}

/// Of each array the rows that an index of NumPy's takes, a slice or whatever else; of contacts
/// those of these rows.
Depths part_of(const Depths& d, const py::object& index) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::object rows = numpy.attr("atleast_1d")(numpy.attr("arange")(d.reason.size())[index]);
  const auto take = [&](const auto& array) {
    return array[rows].template cast<std::decay_t<decltype(array)>>();
  };
  Depths out = d;
  out.status = take(d.status);
  out.reason.clear();
  for (const py::handle i : rows) out.reason.push_back(d.reason[i.cast<std::size_t>()]);
  for (auto member : {&Depths::depth, &Depths::sigma, &Depths::pose, &Depths::device,
                      &Depths::lower_bound, &Depths::residual, &Depths::clearance, &Depths::within})
    out.*member = take(d.*member);
  for (auto member : {&Depths::contacts, &Depths::iterations}) out.*member = take(d.*member);
  for (auto member : {&Depths::converged, &Depths::jumped, &Depths::late})
    out.*member = take(d.*member);
  // Where each of the rows taken has its contacts.
  py::list from, to;
  std::size_t new_row = 0;
  for (const py::handle row : rows) {
    const py::array mine =
        numpy.attr("flatnonzero")(d.contact_row.attr("__eq__")(row)).cast<py::array>();
    for (const py::handle k : mine) from.append(k), to.append(new_row);
    ++new_row;
  }
  const py::object picked = numpy.attr("array")(from, "int64");
  out.contact_row = numpy.attr("array")(to, "int64");
  for (auto member : {&Depths::contact_point, &Depths::contact_normal, &Depths::contact_multiplier})
    out.*member = (d.*member)[picked].cast<py::array_t<double>>();
  return out;
}

py::tuple state_of(const Depths& d) {
  return py::make_tuple(d.status, d.reason, d.depth, d.sigma, d.pose, d.device, d.lower_bound,
                        d.residual, d.clearance, d.within, d.contacts, d.iterations, d.converged,
                        d.jumped, d.late, d.contact_row, d.contact_point, d.contact_normal,
                        d.contact_multiplier);
}
Depths of_state(const py::tuple& t) {
  Depths d;
  d.status = t[0].cast<py::array>();
  d.reason = t[1].cast<std::vector<std::string>>();
  std::size_t i = 2;
  const auto read = [&](auto&... members) {
    ((members = t[i++].template cast<std::decay_t<decltype(members)>>()), ...);
  };
  read(d.depth, d.sigma, d.pose, d.device, d.lower_bound, d.residual, d.clearance, d.within,
       d.contacts, d.iterations, d.converged, d.jumped, d.late, d.contact_row, d.contact_point,
       d.contact_normal, d.contact_multiplier);
  return d;
}

std::string words_for(const Depths& d) {
  std::size_t penetrating = 0, failed = 0;
  double deepest = 0;
  const std::size_t rows = d.reason.size();
  for (std::size_t i = 0; i < rows; ++i) {
    const double depth = d.depth.data()[i];
    failed += std::isnan(depth);
    penetrating += depth > 0;
    if (depth > deepest) deepest = depth;
  }
  std::ostringstream out;
  out << "<sonde.Depths of " << rows << (rows == 1 ? " pose: " : " poses: ") << penetrating
      << " penetrating";
  if (penetrating > 0) out << ", " << deepest << " m at most";
  if (failed > 0) out << ", " << failed << " failed";
  out << ">";
  return out.str();
}

std::string words_for(const Separation& s) {
  std::ostringstream out;
  out << "<sonde.Separation " << name_of(s.status);
  if (s.status == Status::penetrating)
    out << ", " << s.depth << " m, " << s.contacts.size << " contacts";
  if (s.status == Status::failed) out << ": " << s.reason;
  out << ">";
  return out.str();
}

py::object optional(const std::optional<double>& value) {
  if (!value) return py::none();
  return py::float_(*value);
}

void declare_separation(py::module_& module) {
  using S = Separation;
  py::class_<S>(module, "Separation", "The result of one pose.")
      .def_property_readonly(
          "status", [](const S& s) { return name_of(s.status); },
          "\"separated\", \"penetrating\" or \"failed\".")
      .def_property_readonly(
          "reason", [](const S& s) { return s.status == Status::failed ? s.reason : ""; },
          "Why the pose failed; empty where it did not.")
      .def_readonly("depth", &S::depth, "sqrt(PD_g), m.")
      .def_readonly("sigma", &S::sigma, "The square of the depth, m^2.")
      .def_property_readonly(
          "pose", [](const S& s) { return seven(s.separated); },
          "The separated pose, (7,): px,py,pz,qw,qx,qy,qz.")
      .def_property_readonly(
          "device", [](const S& s) { return seven(s.device); }, "The pose that was given, (7,).")
      .def_property_readonly(
          "lower_bound", [](const S& s) { return optional(s.lower_bound); },
          "Lower bound of the depth, m; None where there is none.")
      .def_property_readonly(
          "clearance",
          [](const S& s) {
            return s.clearance ? py::object(py::float_(s.clearance->distance)) : py::none();
          },
          "Least distance of the bodies where they are apart and that was asked for, m; or None.")
      .def_readonly("residual", &S::residual,
                    "|y - J^T lambda| / |y|: distance from a local optimum.")
      .def_readonly("iterations", &S::iterations, "Steps of the local optimiser.")
      .def_readonly("converged", &S::converged, "False where the budget ran out first.")
      .def_readonly("jumped", &S::jumped, "The force is not continuous here.")
      .def_property_readonly(
          "contact_point",
          [](const S& s) {
            return Contacts({&s, 1}).vectors(&Contact::on_fixed);
          },
          "Points of the contacts, on the fixed body, in its mesh frame, (k, 3), m.")
      .def_property_readonly(
          "contact_normal",
          [](const S& s) {
            return Contacts({&s, 1}).vectors(&Contact::normal);
          },
          "Their normals, unit, from the fixed body to the probe, (k, 3).")
      .def_property_readonly(
          "contact_multiplier",
          [](const S& s) {
            return Contacts({&s, 1}).multipliers();
          },
          "What each carries, m: times the stiffness it is a force, (k,).")
      .def("__repr__", [](const S& s) { return words_for(s); });
}

}  // namespace

Depths depths_of(std::span<const Separation> rows) {
  py::list status;
  std::vector<std::string> reason;
  for (const Separation& s : rows) {
    status.append(name_of(s.status));
    reason.push_back(s.status == Status::failed ? s.reason : "");
  }
  const Contacts contacts(rows);
  py::array_t<std::int64_t> contact_row(static_cast<py::ssize_t>(contacts.row.size()));
  for (std::size_t i = 0; i < contacts.row.size(); ++i)
    contact_row.mutable_data()[i] = static_cast<std::int64_t>(contacts.row[i]);
  return {
      .status = py::module_::import("numpy").attr("array")(status, "U11").cast<py::array>(),
      .reason = std::move(reason),
      .depth = found(rows, [](const Separation& s) { return s.depth; }),
      .sigma = found(rows, [](const Separation& s) { return s.sigma; }),
      .pose = poses_in(rows, &Separation::separated, false),
      .device = poses_in(rows, &Separation::device, true),
      .lower_bound = found(rows, [](const Separation& s) { return s.lower_bound.value_or(none); }),
      .residual = found(rows, [](const Separation& s) { return s.residual; }),
      .clearance = found(
          rows, [](const Separation& s) { return s.clearance ? s.clearance->distance : none; }),
      .within = column<double>(rows, [](const Separation&) { return none; }),
      .contacts = column<std::int64_t>(
          rows,
          [](const Separation& s) { return s.status == Status::failed ? 0 : s.clusters.size; }),
      .iterations = column<std::int64_t>(rows, [](const Separation& s) { return s.iterations; }),
      .converged = column<bool>(rows, [](const Separation& s) { return s.converged; }),
      .jumped = column<bool>(rows, [](const Separation& s) { return s.jumped; }),
      .late = column<bool>(rows, [](const Separation&) { return false; }),
      .contact_row = contact_row,
      .contact_point = contacts.vectors(&Contact::on_fixed),
      .contact_normal = contacts.vectors(&Contact::normal),
      .contact_multiplier = contacts.multipliers(),
  };
}

Depths depths_of(std::span<const Answer> answers) {
  std::vector<Separation> rows;
  for (const Answer& answer : answers) rows.push_back(answer.separation);
  Depths out = depths_of(rows);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const Claim& claim = answers[i].claim;
    if (claim.by != Claim::By::nothing) out.within.mutable_data()[i] = claim.within;
    out.late.mutable_data()[i] = answers[i].late;
  }
  return out;
}

void declare_depths(py::module_& module) {
  declare_separation(module);
  py::class_<Depths>(module, "Depths", "Results as arrays, one row for each pose.")
      .def_readonly("status", &Depths::status, "\"separated\", \"penetrating\" or \"failed\".")
      .def_readonly("reason", &Depths::reason, "Why a pose failed; empty where it did not.")
      .def_readonly("depth", &Depths::depth, "sqrt(PD_g), m; NaN where the pose failed.")
      .def_readonly("sigma", &Depths::sigma, "The square of the depth, m^2.")
      .def_readonly("pose", &Depths::pose, "The separated pose, (n, 7): px,py,pz,qw,qx,qy,qz.")
      .def_readonly("device", &Depths::device, "The pose that was given, (n, 7).")
      .def_readonly("lower_bound", &Depths::lower_bound,
                    "Lower bound of the depth, m; NaN where there is none.")
      .def_readonly("clearance", &Depths::clearance,
                    "Least distance of the bodies where they are apart, if that was asked for, m;\n"
                    "else NaN.")
      .def_readonly("within", &Depths::within,
                    "What the depth is claimed to be within, as a share of it, where a time or an\n"
                    "accuracy was asked for; else NaN.")
      .def_readonly("late", &Depths::late, "It took over 1.1 times the time that was asked for.")
      .def_readonly("contacts", &Depths::contacts,
                    "Number of contact clusters that carry the separation.")
      .def_readonly("contact_row", &Depths::contact_row,
                    "Of each contact of all poses, the row of its pose, (m,).")
      .def_readonly("contact_point", &Depths::contact_point,
                    "Their points on the fixed body, in its mesh frame, (m, 3), m.")
      .def_readonly("contact_normal", &Depths::contact_normal,
                    "Their normals, unit, from the fixed body to the probe, (m, 3).")
      .def_readonly("contact_multiplier", &Depths::contact_multiplier,
                    "What each carries, m: times the stiffness it is a force, (m,).")
      .def_readonly("residual", &Depths::residual,
                    "|y - J^T lambda| / |y|: distance from a local optimum.")
      .def_readonly("iterations", &Depths::iterations, "Steps of the local optimiser.")
      .def_readonly("converged", &Depths::converged, "False where the budget ran out first.")
      .def_readonly("jumped", &Depths::jumped,
                    "The force is not continuous here: a search found the separated pose,\n"
                    "or the path led over an edge.")
      .def("__len__", [](const Depths& d) { return d.reason.size(); })
      .def("__getitem__", &part_of, "index"_a)
      .def("__repr__", [](const Depths& d) { return words_for(d); })
      .def(py::pickle(&state_of, &of_state));
}

}  // namespace sonde::python
