// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/depths.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <utility>

#include "app/python/poses.hpp"
#include "app/python/words.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Goes through all columns of numbers: name, table, member and words of each.
void each_column(const auto& use) {
  constexpr auto rows = &Depths::rows;
  use("depth", rows, &DepthRow::depth, "sqrt(PD_g), m; NaN where the pose failed.");
  use("sigma", rows, &DepthRow::sigma, "The square of the depth, m^2.");
  use("pose", rows, &DepthRow::pose, "The separated pose, (n, 7): px,py,pz,qw,qx,qy,qz.");
  use("device", rows, &DepthRow::device, "The pose that was given, (n, 7).");
  use("lower_bound", rows, &DepthRow::lower_bound,
      "Lower bound of the depth, m; NaN where there is none.");
  use("clearance", rows, &DepthRow::clearance,
      "Least distance of the bodies where they are apart, if that was asked for, m;\n"
      "else NaN.");
  use("within", rows, &DepthRow::within,
      "What the depth is claimed to be within, as a share of it, where a time or an\n"
      "accuracy was asked for; else NaN.");
  use("late", rows, &DepthRow::late, "It took over 1.1 times the time that was asked for.");
  use("contacts", rows, &DepthRow::contacts,
      "Number of contact clusters that carry the separation.");
  use("residual", rows, &DepthRow::residual,
      "|y - J^T lambda| / |y|: distance from a local optimum.");
  use("iterations", rows, &DepthRow::iterations, "Steps of the local optimiser.");
  use("converged", rows, &DepthRow::converged, "False where the budget ran out first.");
  use("jumped", rows, &DepthRow::jumped,
      "The force is not continuous here: a search found the separated pose,\n"
      "or the path led over an edge.");
  constexpr auto contacts = &Depths::contacts;
  use("contact_row", contacts, &ContactRow::row,
      "Of each contact of all poses, the row of its pose, (m,).");
  use("contact_point", contacts, &ContactRow::point,
      "Their points on the fixed body, in its mesh frame, (m, 3), m.");
  use("contact_normal", contacts, &ContactRow::normal,
      "Their normals, unit, from the fixed body to the probe, (m, 3).");
  use("contact_multiplier", contacts, &ContactRow::multiplier,
      "What each carries, m: times the stiffness it is a force, (m,).");
}

/// The numbers of a row's member, of which there may be several.
template <class T>
std::span<T> parts_of(T& one) {
  return {&one, 1};
}
template <class T, std::size_t n>
std::span<T> parts_of(std::array<T, n>& several) {
  return several;
}
template <class T, std::size_t n>
std::span<const T> parts_of(const std::array<T, n>& several) {
  return several;
}
template <class T>
constexpr bool is_one = std::is_arithmetic_v<T>;
template <class T>
constexpr std::size_t count_in = 1;
template <class T, std::size_t n>
constexpr std::size_t count_in<std::array<T, n>> = n;

template <class Row, class Member>
py::object array_of(const std::vector<Row>& rows, Member Row::*member) {
  using Number = std::remove_cvref_t<decltype(parts_of(std::declval<Member&>())[0])>;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows.size())};
  if (!is_one<Member>) shape.push_back(count_in<Member>);
  py::array_t<Number> out(shape);
  Number* to = out.mutable_data();
  for (const Row& row : rows) to = std::ranges::copy(parts_of(row.*member), to).out;
  return out;
}

/// Reads what array_of wrote.
template <class Row, class Member>
void read_array(std::vector<Row>& rows, Member Row::*member, const py::object& given) {
  using Number = std::remove_cvref_t<decltype(parts_of(std::declval<Member&>())[0])>;
  const auto array = given.cast<py::array_t<Number, py::array::c_style>>();
  rows.resize(static_cast<std::size_t>(array.ndim() > 0 ? array.shape(0) : 0));
  if (static_cast<std::size_t>(array.size()) != rows.size() * count_in<Member>)
    throw py::value_error("this is no state of Depths");
  const Number* from = array.data();
  for (Row& row : rows)
    for (Number& number : parts_of(row.*member)) number = *from++;
}

/// Words of the same width, which is that of the longest.
py::object status_of_rows(const Depths& d) {
  constexpr std::size_t width = 11;
  py::array out(py::dtype("U11"), static_cast<py::ssize_t>(d.rows.size()));
  auto* to = static_cast<char32_t*>(out.mutable_data());
  std::fill_n(to, width * d.rows.size(), U'\0');
  for (const DepthRow& row : d.rows) {
    const char* word = name_of(row.status);
    std::copy_n(word, std::strlen(word), to);
    to += width;
  }
  return out;
}

/// The array of that name, made when it is first asked for.
py::object kept(Depths& d, std::string_view name, const auto& make) {
  py::object& array = d.arrays[name];
  if (!array) array = make();
  return array;
}

/// The rows that an index of NumPy's takes, a slice or whatever else, with their contacts.
Depths part_of(const Depths& d, const py::object& index) {
  const py::module_ numpy = py::module_::import("numpy");
  const py::array_t<std::int64_t> taken =
      numpy.attr("ravel")(numpy.attr("arange")(d.rows.size())[index]);
  Depths out;
  out.pair = d.pair;
  for (py::ssize_t i = 0; i < taken.size(); ++i) {
    const std::int64_t row = taken.data()[i];
    out.rows.push_back(d.rows[static_cast<std::size_t>(row)]);
    const auto first = std::ranges::lower_bound(d.contacts, row, {}, &ContactRow::row),
               last = std::ranges::upper_bound(d.contacts, row, {}, &ContactRow::row);
    for (ContactRow contact : std::span(first, last)) {
      contact.row = i;
      out.contacts.push_back(contact);
    }
  }
  return out;
}

py::tuple state_of(const Depths& d) {
  py::list statuses, reasons, columns;
  for (const DepthRow& row : d.rows)
    statuses.append(name_of(row.status)), reasons.append(row.reason);
  each_column([&](const char*, auto table, auto member, const char*) {
    columns.append(array_of(d.*table, member));
  });
  return py::make_tuple(d.pair.probe, d.pair.fixed, statuses, reasons, columns);
}

Depths of_state(const py::tuple& state) {
  Depths out;
  out.pair = {state[0].cast<std::uint64_t>(), state[1].cast<std::uint64_t>()};
  const auto statuses = state[2].cast<std::vector<std::string>>();
  const auto reasons = state[3].cast<std::vector<std::string>>();
  std::size_t next = 0;
  const auto columns = state[4].cast<py::list>();
  each_column([&](const char*, auto table, auto member, const char*) {
    read_array(out.*table, member, columns[next++]);
  });
  if (statuses.size() != out.rows.size() || reasons.size() != out.rows.size())
    throw py::value_error("this is no state of Depths");
  for (std::size_t i = 0; i < out.rows.size(); ++i)
    out.rows[i].status = status_of(statuses[i]), out.rows[i].reason = reasons[i];
  return out;
}

std::string words_for(const Depths& d) {
  std::size_t penetrating = 0, failed = 0;
  double deepest = 0;
  for (const DepthRow& row : d.rows) {
    failed += std::isnan(row.depth);
    penetrating += row.depth > 0;
    if (row.depth > deepest) deepest = row.depth;
  }
  std::ostringstream out;
  out << "<sonde.Depths of " << d.rows.size() << (d.rows.size() == 1 ? " pose: " : " poses: ")
      << penetrating << " penetrating";
  if (penetrating > 0) out << ", " << deepest << " m at most";
  if (failed > 0) out << ", " << failed << " failed";
  out << ">";
  return out.str();
}

std::vector<std::string> reasons_of(const Depths& d) {
  std::vector<std::string> out;
  for (const DepthRow& row : d.rows) out.push_back(row.reason);
  return out;
}

std::array<double, 3> array3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

PoseResult::PoseResult(const Separation& s) {
  row.status = s.status;
  row.device = numbers_of(s.device);
  row.within = none;
  row.iterations = s.iterations;
  row.converged = s.converged;
  row.jumped = s.jumped;
  if (s.status == Status::failed) {  // what it does not have is not a number
    row.reason = s.reason;
    row.depth = row.sigma = row.lower_bound = row.residual = row.clearance = none;
    row.pose.fill(none);
    return;
  }
  row.depth = s.depth;
  row.sigma = s.sigma;
  row.pose = numbers_of(s.separated);
  row.lower_bound = s.lower_bound.value_or(none);
  row.residual = s.residual;
  row.clearance = s.clearance ? s.clearance->distance : none;
  row.contacts = s.clusters.size;
  if (s.status != Status::penetrating) return;
  for (const Contact& c : s.contacts)
    contacts.push_back(
        {.point = array3(c.on_fixed), .normal = array3(c.normal), .multiplier = c.multiplier});
}

PoseResult::PoseResult(const Answer& answer) : PoseResult(answer.separation) {
  if (answer.claim.by != Claim::By::nothing) row.within = answer.claim.within;
  row.late = answer.late;
}

Depths depths_of(const std::vector<PoseResult>& results, const PairMark& pair) {
  Depths out;
  out.pair = pair;
  out.rows.reserve(results.size());
  for (const PoseResult& result : results) {
    for (ContactRow contact : result.contacts) {
      contact.row = static_cast<std::int64_t>(out.rows.size());
      out.contacts.push_back(contact);
    }
    out.rows.push_back(result.row);
  }
  return out;
}

void declare_depths(py::module_& module) {
  py::class_<Depths> depths(module, "Depths", "Results as arrays, one row for each pose.");
  depths
      .def_property_readonly(
          "status", [](Depths& d) { return kept(d, "status", [&] { return status_of_rows(d); }); },
          "\"separated\", \"penetrating\" or \"failed\".")
      .def_property_readonly("reason", &reasons_of, "Why a pose failed; empty where it did not.")
      .def("__len__", [](const Depths& d) { return d.rows.size(); })
      .def("__getitem__", &part_of, "index"_a)
      .def("__repr__", [](const Depths& d) { return words_for(d); })
      .def(py::pickle([](const Depths& d) { return state_of(d); }, &of_state));
  each_column([&](const char* name, auto table, auto member, const char* words) {
    depths.def_property_readonly(
        name, [=](Depths& d) { return kept(d, name, [&] { return array_of(d.*table, member); }); },
        words);
  });
}

}  // namespace sonde::python
