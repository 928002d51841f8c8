// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/gains_text.hpp"

#include <gtest/gtest.h>

namespace sonde::ui::test {
namespace {

Coupling gains_of(Coupling::Mode mode) {
  Coupling out;
  out.mode = mode;
  out.k = 300;
  out.b_t = 0.5;
  out.k_t = 250;
  out.k_r = 0.25;
  return out;
}

TEST(GainsText, names_what_the_mode_has) {
  EXPECT_EQ(gains_text(gains_of(Coupling::Mode::object)), "k 300 N/m");
  EXPECT_EQ(gains_text(gains_of(Coupling::Mode::damped)), "k 300 N/m\nb_t 0.500 N·s/m");
  EXPECT_EQ(gains_text(gains_of(Coupling::Mode::classic)), "k_t 250 N/m\nk_r 0.250 N·m/rad");
}

TEST(GainsText, on_the_way_to_another_mode_either_has_its_share) {
  GainGlide::Blend blend;
  blend.before = gains_of(Coupling::Mode::object);
  blend.now = gains_of(Coupling::Mode::classic);
  blend.share = 0.25;
  EXPECT_EQ(gains_text(blend), "75.0 % of k 300 N/m\nand 25.0 % of k_t 250 N/m\nk_r 0.250 N·m/rad");
  blend.share = 1;
  EXPECT_EQ(gains_text(blend), gains_text(blend.now)) << "it has arrived";
}

}  // namespace
}  // namespace sonde::ui::test
