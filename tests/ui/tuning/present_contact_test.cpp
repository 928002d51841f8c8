// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/present_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde::ui::test {
namespace {

/// N/m or N·m/rad; NaN where the study has no such contact.
double stiffness_in(const TuningResults& results, GainAxis axis, const std::string& kind,
                    double damping) {
  const auto found = boundary_in(results, axis, kind, damping);
  return found ? found->stiffness : NAN;
}

using sonde::test::column;
using sonde::test::line;
using sonde::test::results;

/// By hand: the least of the situations of a kind, at the nearest damping.
TEST(PresentContact, has_the_least_boundary_of_its_kind_at_the_nearest_damping) {
  TuningResults r = results();
  r.lines = {line(0, GainAxis::translation, {column(0, 100), column(2, 300)}),
             line(1, GainAxis::translation, {column(0, 40), column(2, 500, 500, HoldFault::none)})};
  r.lines[1].columns[1].stable.fault = HoldFault::none;
  const std::string flat = r.lines[0].kind, edge = r.lines[1].kind;
  ASSERT_NE(flat, edge);
  EXPECT_EQ(stiffness_in(r, GainAxis::translation, flat, 0.4), 100);
  EXPECT_EQ(stiffness_in(r, GainAxis::translation, flat, 1.6), 300);
  EXPECT_EQ(stiffness_in(r, GainAxis::translation, edge, 0), 40);
  EXPECT_TRUE(std::isinf(stiffness_in(r, GainAxis::translation, edge, 2))) << "nothing failed";
  EXPECT_FALSE(boundary_in(r, GainAxis::translation, "jammed", 0));
  EXPECT_FALSE(boundary_in(r, GainAxis::rotation, flat, 0));
  r.lines.push_back(r.lines[0]);
  r.lines.back().assumed = "mass";
  r.lines.back().columns[0].stable.stiffness = 7;
  EXPECT_EQ(stiffness_in(r, GainAxis::translation, flat, 0), 100) << "of the profile as it is";
}

TEST(PresentContact, its_boundary_does_not_rest_on_friction_or_on_soft_knocks) {
  TuningResults r = results();
  r.lines = {line(0, GainAxis::object, {column(0, 1400, 1400, HoldFault::unstable)})};
  TuningColumn& column = r.lines[0].columns[0];
  column.harder_knocks = {900, HoldFault::unstable};
  column.without_friction = {500, HoldFault::unstable};
  const std::string flat = r.lines[0].kind;
  EXPECT_EQ(stiffness_in(r, GainAxis::object, flat, 0), 500);
  EXPECT_EQ(words_of(*boundary_in(r, GainAxis::object, flat, 0)), "a light hand, without friction");
  r.trusts_friction = true;
  EXPECT_EQ(stiffness_in(r, GainAxis::object, flat, 0), 900) << "as asked; knocks still count";
  EXPECT_EQ(words_of(*boundary_in(r, GainAxis::object, flat, 0)), "a light hand, at harder knocks");
  column.harder_knocks = {1e5, HoldFault::none};
  EXPECT_EQ(stiffness_in(r, GainAxis::object, flat, 0), 1400);
  EXPECT_EQ(words_of(*boundary_in(r, GainAxis::object, flat, 0)), "a light hand");
}

TEST(PresentContact, the_words_say_on_which_side_of_the_boundary_it_is) {
  EXPECT_EQ(distance_text(450, 900), "could be 2.00 times as stiff");
  EXPECT_EQ(distance_text(63'270, 900), "70.3 times too stiff");
  EXPECT_EQ(distance_text(900, INFINITY), "");
}

TEST(PresentContact, nothing_holds_a_probe_that_is_free) {
  Separation free;
  EXPECT_EQ(kind_of_contact(free), "");
  free.status = Status::penetrating;
  EXPECT_EQ(kind_of_contact(free), "") << "without contacts";
}

}  // namespace
}  // namespace sonde::ui::test
