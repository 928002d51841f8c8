// SPDX-License-Identifier: GPL-3.0-or-later
// That rows come back from a file is tested by recorded_tick_test.cpp; here, which field a column
// has.
#include "engine/recording/tick_columns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde {
namespace {

template <class Row>
const Column<Row>* column_named(std::span<const Column<Row>> columns, const std::string& name) {
  for (const Column<Row>& column : columns)
    if (column.name == name) return &column;
  ADD_FAILURE() << "there is no column " << name;
  return columns.data();
}

using Expected = std::vector<std::pair<const char*, double>>;

template <class Row>
void expect_fields(std::span<const Column<Row>> columns, const Row& row, const Expected& all) {
  EXPECT_EQ(all.size(), columns.size());
  for (const auto& [name, value] : all)
    EXPECT_EQ(column_named(columns, name)->get(row), value) << name;
}

// Reference: the names, as the manual explains them (resources/docs/use/files.md).
TEST(TickColumns, each_has_the_field_of_its_name) {
  Snapshot tick;
  tick.time = 1.5;
  tick.tick = 7;
  Separation& s = tick.separation;
  s.device = {Quat(0.5, 0.5, -0.5, 0.5), Vec3(1, 2, 3)};
  s.separated = {s.device.q * Quat(0.6, 0, 0.8, 0), Vec3(1.25, 1.5, 3.125)};
  s.status = Status::penetrating;
  s.depth = 0.1, s.translation = 0.2, s.rotation = 0.3, s.residual = 0.4, s.iterations = 5;
  s.converged = false, s.jumped = true;
  s.contacts.size = 3, s.clusters.size = 2;
  tick.wrench = {Vec3(11, 12, 13), Vec3(14, 15, 16), true};
  tick.hand.withheld = Withheld::shut_down;
  tick.hand.share = 0.25, tick.hand.slewed = true, tick.hand.held = false;
  tick.hand.energy = {.given = 21, .excess = 22, .dissipated = 23, .damping = 24};
  tick.hand.rows.age_ticks = 31, tick.hand.rows.age = 0.032;
  tick.hand.rows.in_step = false, tick.hand.rows.held_back = true;
  tick.hand.rows.reach = 0.033, tick.hand.rows.refresh_us = 34;
  tick.tick_us = 41, tick.rate_hz = 42, tick.late = 43;
  tick.coupling.mode = Coupling::Mode::classic;
  tick.coupling.k = 51, tick.coupling.k_t = 52, tick.coupling.k_r = 53;
  tick.coupling.b_t = 54, tick.coupling.b_r = 55;
  tick.coupling.max_force = 56, tick.coupling.max_torque = 57;
  expect_fields(tick_columns(), tick,
                {{"t", 1.5},
                 {"tick", 7},
                 {"px", 1},
                 {"py", 2},
                 {"pz", 3},
                 {"qw", 0.5},
                 {"qx", 0.5},
                 {"qy", -0.5},
                 {"qz", 0.5},
                 {"status", static_cast<double>(Status::penetrating)},
                 {"mx", 0.25},
                 {"my", -0.5},
                 {"mz", 0.125},
                 {"mqw", (s.device.q.conjugate() * s.separated.q).w()},
                 {"mqx", (s.device.q.conjugate() * s.separated.q).x()},
                 {"mqy", (s.device.q.conjugate() * s.separated.q).y()},
                 {"mqz", (s.device.q.conjugate() * s.separated.q).z()},
                 {"depth", 0.1},
                 {"moved", 0.2},
                 {"turned", 0.3},
                 {"residual", 0.4},
                 {"iterations", 5},
                 {"converged", 0},
                 {"jumped", 1},
                 {"contacts", 3},
                 {"clusters", 2},
                 {"fx", 11},
                 {"fy", 12},
                 {"fz", 13},
                 {"tx", 14},
                 {"ty", 15},
                 {"tz", 16},
                 {"saturated", 1},
                 {"withheld", static_cast<double>(Withheld::shut_down)},
                 {"share", 0.25},
                 {"slewed", 1},
                 {"held", 0},
                 {"given", 21},
                 {"excess", 22},
                 {"dissipated", 23},
                 {"damping", 24},
                 {"age_ticks", 31},
                 {"age", 0.032},
                 {"in_step", 0},
                 {"held_back", 1},
                 {"reach", 0.033},
                 {"refresh_us", 34},
                 {"tick_us", 41},
                 {"rate_hz", 42},
                 {"late", 43},
                 {"mode", static_cast<double>(Coupling::Mode::classic)},
                 {"k", 51},
                 {"k_t", 52},
                 {"k_r", 53},
                 {"b_t", 54},
                 {"b_r", 55},
                 {"max_force", 56},
                 {"max_torque", 57}});
  // The motion is in the frame of the device: the turn by which the probe is turned there.
  const Quat motion = s.device.q.conjugate() * s.separated.q;
  EXPECT_NEAR(motion.w(), 0.6, 1e-15);
  EXPECT_NEAR(motion.y(), 0.8, 1e-15);
}

TEST(TickColumns, contacts_and_searches_have_the_fields_of_their_names) {
  const Contact contact{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), 10, 11};
  expect_fields(contact_columns(), contact,
                {{"ax", 1},
                 {"ay", 2},
                 {"az", 3},
                 {"bx", 4},
                 {"by", 5},
                 {"bz", 6},
                 {"nx", 7},
                 {"ny", 8},
                 {"nz", 9},
                 {"gap", 10},
                 {"multiplier", 11}});
  RecordedSearch search;
  search.time = 1;
  search.result.device = {Quat(0.5, -0.5, 0.25, 0.75), Vec3(2, 3, 4)};
  search.result.nearest = FoundSeparation{5, {Quat(6, 7, 8, 9), Vec3(10, 11, 12)}};
  search.result.pdt = FoundSeparation{13, {Quat(14, 15, 16, 17), Vec3(18, 19, 20)}};
  search.result.lower_bound = 21;
  search.result.time_us = 22;
  expect_fields(search_columns(), search, {{"t", 1},
                                           {"px", 2},
                                           {"py", 3},
                                           {"pz", 4},
                                           {"qw", 0.5},
                                           {"qx", -0.5},
                                           {"qy", 0.25},
                                           {"qz", 0.75},
                                           {"nearest", 5},
                                           {"nearest_px", 10},
                                           {"nearest_py", 11},
                                           {"nearest_pz", 12},
                                           {"nearest_qw", 6},
                                           {"nearest_qx", 7},
                                           {"nearest_qy", 8},
                                           {"nearest_qz", 9},
                                           {"pdt", 13},
                                           {"pdt_px", 18},
                                           {"pdt_py", 19},
                                           {"pdt_pz", 20},
                                           {"pdt_qw", 14},
                                           {"pdt_qx", 15},
                                           {"pdt_qy", 16},
                                           {"pdt_qz", 17},
                                           {"lower_bound", 21},
                                           {"time_us", 22}});
}

/// A row has what was put into it, and each column by itself.
template <class Row>
void expect_set_alone(std::span<const Column<Row>> columns, const Row& from, const Row& empty,
                      const std::set<std::string>& beside) {
  std::set<std::string> names;
  for (const Column<Row>& column : columns) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    Row row = empty;
    column.set(row, column.get(from));
    EXPECT_EQ(column.get(row), column.get(from)) << column.name;
    for (const Column<Row>& other : columns)
      if (&other != &column && !beside.contains(other.name)) {
        EXPECT_EQ(other.get(row), other.get(empty)) << other.name << " by " << column.name;
      }
  }
}

TEST(TickColumns, a_column_sets_its_own_field_alone) {
  // But for the motion, which is relative to the device pose.
  const std::set<std::string> motion{"mx", "my", "mz", "mqw", "mqx", "mqy", "mqz"};
  for (const Snapshot& tick : test::made_up_ticks(40))
    expect_set_alone(tick_columns(), tick, Snapshot(), motion);
  expect_set_alone(contact_columns(), Contact{Vec3(1, 2, 3), Vec3(4, 5, 6), Vec3(7, 8, 9), 10, 11},
                   Contact(), {});
  RecordedSearch full, without;
  without.result.nearest = without.result.pdt = FoundSeparation();
  without.result.lower_bound = 0;
  full = without;
  full.time = 1.5;
  full.result.nearest = FoundSeparation{5, {Quat(6, 7, 8, 9), Vec3(10, 11, 12)}};
  full.result.pdt = FoundSeparation{13, {Quat(14, 15, 16, 17), Vec3(18, 19, 20)}};
  full.result.lower_bound = 21;
  expect_set_alone(search_columns(), full, without, {});
}

TEST(TickColumns, what_a_search_did_not_find_is_no_number) {
  const RecordedSearch none;
  for (const Column<RecordedSearch>& column : search_columns()) {
    const std::string name = column.name;
    const bool found =
        name.starts_with("nearest") || name.starts_with("pdt") || name == "lower_bound";
    EXPECT_EQ(std::isnan(column.get(none)), found) << name;
    if (!found) continue;
    RecordedSearch row;
    column.set(row, std::nan(""));
    EXPECT_FALSE(row.result.nearest || row.result.pdt || row.result.lower_bound) << name;
    column.set(row, 3);
    EXPECT_EQ(column.get(row), 3) << name;
  }
}

TEST(TickColumns, a_number_beyond_an_enumeration_is_its_last) {
  Snapshot tick;
  column_named(tick_columns(), "status")->set(tick, 200);
  EXPECT_EQ(tick.separation.status, Status::failed);
  column_named(tick_columns(), "status")->set(tick, 0);
  EXPECT_EQ(tick.separation.status, Status::separated);
  column_named(tick_columns(), "withheld")->set(tick, 200);
  EXPECT_EQ(tick.hand.withheld, Withheld::shut_down);
  column_named(tick_columns(), "mode")->set(tick, 200);
  EXPECT_EQ(tick.coupling.mode, Coupling::Mode::damped);
}

}  // namespace
}  // namespace sonde
