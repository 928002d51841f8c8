// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/present_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace sonde::ui::test {
namespace {

TEST(PresentContact, the_words_say_on_which_side_of_what_is_allowed_it_is) {
  EXPECT_EQ(distance_text(450, 900), "could be 2.00 times as stiff");
  EXPECT_EQ(distance_text(63'270, 900), "70.3 times too stiff");
  EXPECT_EQ(distance_text(900.1, 900), "as stiff as it may be") << "to three digits";
  EXPECT_EQ(distance_text(899.9, 900), "as stiff as it may be");
  EXPECT_EQ(distance_text(900, 0), "no stiffness is good");
  EXPECT_EQ(distance_text(900, INFINITY), "");
}

TEST(PresentContact, the_words_name_the_limit) {
  const GainLimit rest{"rest", 170, "flat", "limp"};
  EXPECT_EQ(allowed_text(rest, GainAxis::object, 85),
            "the study allows 170 N/m, limited by what comes to rest (flat contact, limp hand): "
            "could be 2.00 times as stiff");
  EXPECT_EQ(allowed_text({"rest", 0, "flat", "limp"}, GainAxis::object, 85),
            "the study allows no stiffness, limited by what comes to rest (flat contact, limp "
            "hand)");
}

TEST(PresentContact, nothing_holds_a_probe_that_is_free) {
  Separation free;
  EXPECT_EQ(kind_of_contact(free), "");
  free.status = Status::penetrating;
  EXPECT_EQ(kind_of_contact(free), "") << "without contacts";
}

}  // namespace
}  // namespace sonde::ui::test
