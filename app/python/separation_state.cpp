// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/separation_state.hpp"

#include <pybind11/stl.h>

#include <type_traits>

#include "app/python/words.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;

struct Writer {
  py::list out;
  template <class T>
  void operator()(const T& number) {
    out.append(py::cast(number));
  }
};

struct Reader {
  py::list in;
  std::size_t next = 0;
  template <class T>
  void operator()(T& number) {
    number = in[next++].cast<T>();
  }
};

// Each of these goes through the numbers of what is written, or of what is read.

void each(auto& use, auto& vector, int size) {
  for (int i = 0; i < size; ++i) use(vector[i]);
}
void each_of_pose(auto& use, auto& pose) {
  each(use, pose.q.coeffs(), 4);
  each(use, pose.p, 3);
}
void each_of_contact(auto& use, auto& contact) {
  each(use, contact.on_probe, 3);
  each(use, contact.on_fixed, 3);
  each(use, contact.normal, 3);
  use(contact.gap);
  use(contact.multiplier);
}
/// Those of `all.items` that are valid.
void each_item(auto& use, auto& all, const auto& each_of_item) {
  use(all.size);
  if (all.size < 0 || all.size > ContactSet::capacity)
    throw py::value_error("this is no state of a Separation");
  for (std::size_t i = 0; i < static_cast<std::size_t>(all.size); ++i) each_of_item(all.items[i]);
}
void each_of_clearance(auto& use, auto& clearance) {
  bool is_there = clearance.has_value();
  use(is_there);
  if (!is_there) return;
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(clearance)>>) clearance.emplace();
  use(clearance->distance);
  each(use, clearance->on_probe, 3);
  each(use, clearance->on_fixed, 3);
  use(clearance->overlapping);
}
/// All but the status, the reason and what is never asked for here, where the time went.
void each_number(auto& use, auto& s) {
  each_of_pose(use, s.device);
  each_of_pose(use, s.separated);
  use(s.sigma), use(s.depth), use(s.translation), use(s.rotation);
  each_item(use, s.contacts, [&](auto& contact) { each_of_contact(use, contact); });
  each_item(use, s.clusters, [&](auto& cluster) {
    each_of_contact(use, cluster.contact);
    use(cluster.pitch), use(cluster.rows), use(cluster.id);
  });
  use(s.residual), use(s.iterations), use(s.converged), use(s.limited), use(s.jumped);
  use(s.lagged), use(s.released), use(s.far_out), use(s.lower_bound), use(s.pdt);
  each_of_clearance(use, s.clearance);
}

}  // namespace

py::tuple state_of(const Found& found) {
  Writer writer;
  each_number(writer, found.separation);
  return py::make_tuple(found.pair.probe, found.pair.fixed, name_of(found.separation.status),
                        found.reason, writer.out);
}

Found found_of(const py::tuple& state) {
  Found out({}, {state[0].cast<std::uint64_t>(), state[1].cast<std::uint64_t>()});
  out.separation.status = status_of(state[2].cast<std::string>());
  out.reason = state[3].cast<std::string>();
  Reader reader{state[4].cast<py::list>()};
  each_number(reader, out.separation);
  return out;
}

}  // namespace sonde::python
