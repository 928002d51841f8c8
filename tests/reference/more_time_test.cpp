// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: counted by hand.
#include "tests/reference/more_time.hpp"

#include <gtest/gtest.h>

namespace sonde::reference {
namespace {

/// A search that ended so deep, where 1 m is the reference.
Measured ended_at(double depth) {
  Measured out;
  out.reference = 1;
  out.got.status = Status::penetrating;
  out.got.depth = depth;
  return out;
}

TEST(MoreTime, counts_what_is_worse_than_with_any_budget_before) {
  const MoreTime budgets[] = {{1000, {ended_at(1), ended_at(1.2), ended_at(3)}},
                              {2000, {ended_at(1.04), ended_at(1.3), ended_at(1)}},
                              {4000, {ended_at(1.04), ended_at(1.21), ended_at(2)}}};
  const bench::Table table = more_time(budgets);
  using Row = std::vector<bench::Cell>;
  const auto n = [](int count) { return bench::Cell{std::int64_t{count}}; };
  ASSERT_EQ(table.rows.size(), 3u);
  EXPECT_EQ(table.rows[0], (Row{1000.0, n(3), n(1), n(1), n(0), n(0)}));
  EXPECT_EQ(table.rows[1], (Row{2000.0, n(3), n(1), n(2), n(1), n(0)}));
  EXPECT_EQ(table.rows[2], (Row{4000.0, n(3), n(0), n(1), n(1), n(1)}));
}

}  // namespace
}  // namespace sonde::reference
