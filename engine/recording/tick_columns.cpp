// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/tick_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "engine/base/numbers.hpp"

namespace sonde {
namespace {

/// A field that is stored unchanged. `Field` selects it: a lambda without captures.
template <class Row, class Field>
constexpr Column<Row> column(const char* name, const char* unit, Stored as, Field /*field*/) {
  return {name, unit, as, [](const Row& row) { return static_cast<double>(Field{}(row)); },
          [](Row& row, double value) {
            auto& field = Field{}(row);
            field = field_of<std::remove_reference_t<decltype(field)>>(value);
          }};
}

template <class Field>
constexpr Column<Snapshot> of_tick(const char* name, const char* unit, Stored as, Field field) {
  return column<Snapshot>(name, unit, as, field);
}

/// A value of an enumeration with the last value `last`; any larger number in a file becomes that.
template <class Enumeration>
Enumeration one_of(double value, Enumeration last) {
  return static_cast<Enumeration>(std::min(field_of<int>(value), static_cast<int>(last)));
}

/// The separated pose relative to the device pose.
Pose motion_of(const Snapshot& tick) {
  const Separation& s = tick.separation;
  return {s.device.q.conjugate() * s.separated.q, s.separated.p - s.device.p};
}
Pose& read_motion(Snapshot& tick) { return tick.separation.separated; }

const std::array ticks{
    of_tick(
        "t", "s", Stored::f64, [](auto& r) -> auto& { return r.time; }),
    of_tick(
        "tick", "", Stored::u64, [](auto& r) -> auto& { return r.tick; }),
    of_tick(
        "px", "m", Stored::f64, [](auto& r) -> auto& { return r.separation.device.p.x(); }),
    of_tick(
        "py", "m", Stored::f64, [](auto& r) -> auto& { return r.separation.device.p.y(); }),
    of_tick(
        "pz", "m", Stored::f64, [](auto& r) -> auto& { return r.separation.device.p.z(); }),
    of_tick(
        "qw", "", Stored::f64, [](auto& r) -> auto& { return r.separation.device.q.w(); }),
    of_tick(
        "qx", "", Stored::f64, [](auto& r) -> auto& { return r.separation.device.q.x(); }),
    of_tick(
        "qy", "", Stored::f64, [](auto& r) -> auto& { return r.separation.device.q.y(); }),
    of_tick(
        "qz", "", Stored::f64, [](auto& r) -> auto& { return r.separation.device.q.z(); }),
    Column<Snapshot>{
        "status", "", Stored::u8,
        [](const Snapshot& r) { return static_cast<double>(r.separation.status); },
        [](Snapshot& r, double x) { r.separation.status = one_of(x, Status::failed); }},
    Column<Snapshot>{"mx", "m", Stored::f32, [](const Snapshot& r) { return motion_of(r).p.x(); },
                     [](Snapshot& r, double x) { read_motion(r).p.x() = x; }},
    Column<Snapshot>{"my", "m", Stored::f32, [](const Snapshot& r) { return motion_of(r).p.y(); },
                     [](Snapshot& r, double x) { read_motion(r).p.y() = x; }},
    Column<Snapshot>{"mz", "m", Stored::f32, [](const Snapshot& r) { return motion_of(r).p.z(); },
                     [](Snapshot& r, double x) { read_motion(r).p.z() = x; }},
    Column<Snapshot>{"mqw", "", Stored::f32, [](const Snapshot& r) { return motion_of(r).q.w(); },
                     [](Snapshot& r, double x) { read_motion(r).q.w() = x; }},
    Column<Snapshot>{"mqx", "", Stored::f32, [](const Snapshot& r) { return motion_of(r).q.x(); },
                     [](Snapshot& r, double x) { read_motion(r).q.x() = x; }},
    Column<Snapshot>{"mqy", "", Stored::f32, [](const Snapshot& r) { return motion_of(r).q.y(); },
                     [](Snapshot& r, double x) { read_motion(r).q.y() = x; }},
    Column<Snapshot>{"mqz", "", Stored::f32, [](const Snapshot& r) { return motion_of(r).q.z(); },
                     [](Snapshot& r, double x) { read_motion(r).q.z() = x; }},
    of_tick(
        "depth", "m", Stored::f64, [](auto& r) -> auto& { return r.separation.depth; }),
    of_tick(
        "moved", "m", Stored::f32, [](auto& r) -> auto& { return r.separation.translation; }),
    of_tick(
        "turned", "m", Stored::f32, [](auto& r) -> auto& { return r.separation.rotation; }),
    of_tick(
        "residual", "", Stored::f32, [](auto& r) -> auto& { return r.separation.residual; }),
    of_tick(
        "iterations", "", Stored::u32, [](auto& r) -> auto& { return r.separation.iterations; }),
    of_tick(
        "converged", "", Stored::u8, [](auto& r) -> auto& { return r.separation.converged; }),
    of_tick(
        "jumped", "", Stored::u8, [](auto& r) -> auto& { return r.separation.jumped; }),
    of_tick(
        "contacts", "", Stored::u8, [](auto& r) -> auto& { return r.separation.contacts.size; }),
    of_tick(
        "clusters", "", Stored::u8, [](auto& r) -> auto& { return r.separation.clusters.size; }),
    of_tick(
        "fx", "N", Stored::f32, [](auto& r) -> auto& { return r.wrench.force.x(); }),
    of_tick(
        "fy", "N", Stored::f32, [](auto& r) -> auto& { return r.wrench.force.y(); }),
    of_tick(
        "fz", "N", Stored::f32, [](auto& r) -> auto& { return r.wrench.force.z(); }),
    of_tick(
        "tx", "N*m", Stored::f32, [](auto& r) -> auto& { return r.wrench.torque.x(); }),
    of_tick(
        "ty", "N*m", Stored::f32, [](auto& r) -> auto& { return r.wrench.torque.y(); }),
    of_tick(
        "tz", "N*m", Stored::f32, [](auto& r) -> auto& { return r.wrench.torque.z(); }),
    of_tick(
        "saturated", "", Stored::u8, [](auto& r) -> auto& { return r.wrench.saturated; }),
    Column<Snapshot>{
        "withheld", "", Stored::u8,
        [](const Snapshot& r) { return static_cast<double>(r.hand.withheld); },
        [](Snapshot& r, double x) { r.hand.withheld = one_of(x, Withheld::shut_down); }},
    of_tick(
        "share", "", Stored::f32, [](auto& r) -> auto& { return r.hand.share; }),
    of_tick(
        "slewed", "", Stored::u8, [](auto& r) -> auto& { return r.hand.slewed; }),
    of_tick(
        "held", "", Stored::u8, [](auto& r) -> auto& { return r.hand.held; }),
    of_tick(
        "given", "J", Stored::f64, [](auto& r) -> auto& { return r.hand.energy.given; }),
    of_tick(
        "excess", "J", Stored::f32, [](auto& r) -> auto& { return r.hand.energy.excess; }),
    of_tick(
        "dissipated", "J", Stored::f32, [](auto& r) -> auto& { return r.hand.energy.dissipated; }),
    of_tick(
        "damping", "N*s/m", Stored::f32, [](auto& r) -> auto& { return r.hand.energy.damping; }),
    of_tick(
        "age_ticks", "", Stored::u32, [](auto& r) -> auto& { return r.hand.rows.age_ticks; }),
    of_tick(
        "age", "s", Stored::f32, [](auto& r) -> auto& { return r.hand.rows.age; }),
    of_tick(
        "in_step", "", Stored::u8, [](auto& r) -> auto& { return r.hand.rows.in_step; }),
    of_tick(
        "held_back", "", Stored::u8, [](auto& r) -> auto& { return r.hand.rows.held_back; }),
    of_tick(
        "reach", "m", Stored::f32, [](auto& r) -> auto& { return r.hand.rows.reach; }),
    of_tick(
        "refresh_us", "us", Stored::f32, [](auto& r) -> auto& { return r.hand.rows.refresh_us; }),
    of_tick(
        "tick_us", "us", Stored::f32, [](auto& r) -> auto& { return r.tick_us; }),
    of_tick(
        "rate_hz", "Hz", Stored::f32, [](auto& r) -> auto& { return r.rate_hz; }),
    of_tick(
        "late", "", Stored::u64, [](auto& r) -> auto& { return r.late; }),
    Column<Snapshot>{
        "mode", "", Stored::u8,
        [](const Snapshot& r) { return static_cast<double>(r.coupling.mode); },
        [](Snapshot& r, double x) { r.coupling.mode = one_of(x, Coupling::Mode::damped); }},
    of_tick(
        "k", "N/m", Stored::f64, [](auto& r) -> auto& { return r.coupling.k; }),
    of_tick(
        "k_t", "N/m", Stored::f64, [](auto& r) -> auto& { return r.coupling.k_t; }),
    of_tick(
        "k_r", "N*m/rad", Stored::f64, [](auto& r) -> auto& { return r.coupling.k_r; }),
    of_tick(
        "b_t", "N*s/m", Stored::f64, [](auto& r) -> auto& { return r.coupling.b_t; }),
    of_tick(
        "b_r", "N*m*s/rad", Stored::f64, [](auto& r) -> auto& { return r.coupling.b_r; }),
    of_tick(
        "max_force", "N", Stored::f64, [](auto& r) -> auto& { return r.coupling.max_force; }),
    of_tick(
        "max_torque", "N*m", Stored::f64, [](auto& r) -> auto& { return r.coupling.max_torque; }),
};

template <class Field>
constexpr Column<Contact> of_contact(const char* name, const char* unit, Field field) {
  return column<Contact>(name, unit, Stored::f32, field);
}

const std::array contacts{
    of_contact(
        "ax", "m", [](auto& r) -> auto& { return r.on_probe.x(); }),
    of_contact(
        "ay", "m", [](auto& r) -> auto& { return r.on_probe.y(); }),
    of_contact(
        "az", "m", [](auto& r) -> auto& { return r.on_probe.z(); }),
    of_contact(
        "bx", "m", [](auto& r) -> auto& { return r.on_fixed.x(); }),
    of_contact(
        "by", "m", [](auto& r) -> auto& { return r.on_fixed.y(); }),
    of_contact(
        "bz", "m", [](auto& r) -> auto& { return r.on_fixed.z(); }),
    of_contact(
        "nx", "", [](auto& r) -> auto& { return r.normal.x(); }),
    of_contact(
        "ny", "", [](auto& r) -> auto& { return r.normal.y(); }),
    of_contact(
        "nz", "", [](auto& r) -> auto& { return r.normal.z(); }),
    of_contact(
        "gap", "m", [](auto& r) -> auto& { return r.gap; }),
    of_contact(
        "multiplier", "m", [](auto& r) -> auto& { return r.multiplier; }),
};

using Way = std::optional<FoundSeparation>;

/// A number of a way out; NaN if there is none.
template <class Member, class Field>
constexpr Column<RecordedSearch> of_way(const char* name, const char* unit, Member /*way*/,
                                        Field /*field*/) {
  return {name, unit, Stored::f64,
          [](const RecordedSearch& r) {
            const Way& way = Member{}(r);
            return way ? static_cast<double>(Field{}(*way)) : no_number;
          },
          [](RecordedSearch& r, double value) {
            Way& way = Member{}(r);
            if (std::isnan(value)) return;
            if (!way) way.emplace();
            Field{}(*way) = value;
          }};
}

template <class Field>
constexpr Column<RecordedSearch> of_search(const char* name, const char* unit, Field field) {
  return column<RecordedSearch>(name, unit, Stored::f64, field);
}

constexpr auto nearest = [](auto& r) -> auto& { return r.result.nearest; };
constexpr auto straight = [](auto& r) -> auto& { return r.result.pdt; };

const std::array searches{
    of_search(
        "t", "s", [](auto& r) -> auto& { return r.time; }),
    of_search(
        "px", "m", [](auto& r) -> auto& { return r.result.device.p.x(); }),
    of_search(
        "py", "m", [](auto& r) -> auto& { return r.result.device.p.y(); }),
    of_search(
        "pz", "m", [](auto& r) -> auto& { return r.result.device.p.z(); }),
    of_search(
        "qw", "", [](auto& r) -> auto& { return r.result.device.q.w(); }),
    of_search(
        "qx", "", [](auto& r) -> auto& { return r.result.device.q.x(); }),
    of_search(
        "qy", "", [](auto& r) -> auto& { return r.result.device.q.y(); }),
    of_search(
        "qz", "", [](auto& r) -> auto& { return r.result.device.q.z(); }),
    of_way(
        "nearest", "m", nearest, [](auto& w) -> auto& { return w.depth; }),
    of_way(
        "nearest_px", "m", nearest, [](auto& w) -> auto& { return w.separated.p.x(); }),
    of_way(
        "nearest_py", "m", nearest, [](auto& w) -> auto& { return w.separated.p.y(); }),
    of_way(
        "nearest_pz", "m", nearest, [](auto& w) -> auto& { return w.separated.p.z(); }),
    of_way(
        "nearest_qw", "", nearest, [](auto& w) -> auto& { return w.separated.q.w(); }),
    of_way(
        "nearest_qx", "", nearest, [](auto& w) -> auto& { return w.separated.q.x(); }),
    of_way(
        "nearest_qy", "", nearest, [](auto& w) -> auto& { return w.separated.q.y(); }),
    of_way(
        "nearest_qz", "", nearest, [](auto& w) -> auto& { return w.separated.q.z(); }),
    of_way(
        "pdt", "m", straight, [](auto& w) -> auto& { return w.depth; }),
    of_way(
        "pdt_px", "m", straight, [](auto& w) -> auto& { return w.separated.p.x(); }),
    of_way(
        "pdt_py", "m", straight, [](auto& w) -> auto& { return w.separated.p.y(); }),
    of_way(
        "pdt_pz", "m", straight, [](auto& w) -> auto& { return w.separated.p.z(); }),
    of_way(
        "pdt_qw", "", straight, [](auto& w) -> auto& { return w.separated.q.w(); }),
    of_way(
        "pdt_qx", "", straight, [](auto& w) -> auto& { return w.separated.q.x(); }),
    of_way(
        "pdt_qy", "", straight, [](auto& w) -> auto& { return w.separated.q.y(); }),
    of_way(
        "pdt_qz", "", straight, [](auto& w) -> auto& { return w.separated.q.z(); }),
    Column<RecordedSearch>{
        "lower_bound", "m", Stored::f64,
        [](const RecordedSearch& r) { return r.result.lower_bound.value_or(no_number); },
        [](RecordedSearch& r, double x) {
          if (!std::isnan(x)) r.result.lower_bound = x;
        }},
    of_search(
        "time_us", "us", [](auto& r) -> auto& { return r.result.time_us; }),
};

}  // namespace

std::span<const Column<Snapshot>> tick_columns() { return ticks; }
std::span<const Column<Contact>> contact_columns() { return contacts; }
std::span<const Column<RecordedSearch>> search_columns() { return searches; }

}  // namespace sonde
