// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/seeing_menu.hpp"

#include <gtest/gtest.h>

#include <QAction>

#include "tests/ui/actions/seeing_fixture.hpp"
#include "ui/actions/seeing_control.hpp"

namespace sonde::ui::test {
namespace {

class SeeingMenuTest : public SeeingTest {
 protected:
  const Seeing& seeing() { return window->seeing().seeing(); }
  bool checked(const char* name) { return find<QAction>(name)->isChecked(); }
};

TEST_F(SeeingMenuTest, a_look_is_put_on_a_body_and_taken_off_again) {
  const std::tuple<const char*, Look Seeing::*, Look> looks[] = {
      {"xray_fixed", &Seeing::fixed, Look::xray},
      {"xray_probe", &Seeing::probe, Look::xray},
      {"wire_fixed", &Seeing::fixed, Look::wireframe},
      {"wire_probe", &Seeing::probe, Look::wireframe},
      {"hide_fixed", &Seeing::fixed, Look::hidden},
      {"hide_probe", &Seeing::probe, Look::hidden}};
  for (const auto& [name, body, look] : looks) {
    const auto other = body == &Seeing::fixed ? &Seeing::probe : &Seeing::fixed;
    act(name);
    EXPECT_EQ(seeing().*body, look) << name;
    EXPECT_EQ(seeing().*other, Look::opaque) << name;
    EXPECT_EQ(window->viewport().seeing().*body, look) << name;
    act(name);
    EXPECT_EQ(seeing().*body, Look::opaque) << name;
  }
}

TEST_F(SeeingMenuTest, one_look_of_a_body_takes_the_place_of_another) {
  act("xray_fixed");
  act("wire_fixed");
  EXPECT_EQ(seeing().fixed, Look::wireframe);
  EXPECT_FALSE(checked("xray_fixed"));
  EXPECT_TRUE(checked("wire_fixed"));
  EXPECT_FALSE(checked("wire_probe"));
}

TEST_F(SeeingMenuTest, the_menu_follows_what_is_set_in_the_dock) {
  Seeing wanted;
  wanted.probe = Look::hidden;
  wanted.cut.on = true;
  window->seeing().set_seeing(wanted);
  EXPECT_TRUE(checked("hide_probe"));
  EXPECT_TRUE(checked("cut"));
  window->seeing().set_seeing({});
  EXPECT_FALSE(checked("hide_probe"));
  EXPECT_FALSE(checked("cut"));
}

TEST_F(SeeingMenuTest, a_cut_is_toggled_and_flipped) {
  act("cut");
  ASSERT_TRUE(seeing().cut.on);
  const Vec3 normal = seeing().cut.normal;
  act("cut_flip_now");
  EXPECT_EQ(seeing().cut.normal, -normal);
  EXPECT_TRUE(seeing().cut.on);
  act("cut");
  EXPECT_FALSE(seeing().cut.on);
}

TEST_F(SeeingMenuTest, each_direction_is_looked_from_with_its_key) {
  const std::tuple<const char*, Qt::Key, Vec3> directions[] = {
      {"from_right", Qt::Key_1, Vec3::UnitX()}, {"from_left", Qt::Key_2, -Vec3::UnitX()},
      {"from_back", Qt::Key_3, Vec3::UnitY()},  {"from_front", Qt::Key_4, -Vec3::UnitY()},
      {"from_above", Qt::Key_5, Vec3::UnitZ()}, {"from_below", Qt::Key_6, -Vec3::UnitZ()}};
  for (const auto& [name, digit, towards] : directions) {
    key(digit, Qt::ControlModifier);
    EXPECT_LT((window->viewport().camera().axes().towards - towards).norm(), 1e-9) << name;
  }
}

TEST_F(SeeingMenuTest, gaps_and_crossings_are_layers_of_the_view) {
  act("gap_colours");
  EXPECT_TRUE(window->viewport().shown(Layer::gaps));
  act("gap_colours");
  EXPECT_FALSE(window->viewport().shown(Layer::gaps));
  act("show_crossings");
  EXPECT_TRUE(window->viewport().shown(Layer::crossings));
}

TEST_F(SeeingMenuTest, a_search_for_crossings_that_was_given_up_is_not_checked_any_more) {
  act("show_crossings");
  ASSERT_TRUE(checked("show_crossings"));
  emit window->seeing().crossings().given_up();
  EXPECT_FALSE(checked("show_crossings"));
  EXPECT_FALSE(window->viewport().shown(Layer::crossings));
}

}  // namespace
}  // namespace sonde::ui::test
