// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/grip_box.hpp"

#include <gtest/gtest.h>

#include <QPushButton>
#include <optional>
#include <string>
#include <vector>

#include "engine/settings/settings.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/devices/hand_grip.hpp"
#include "ui/panels/slider_row.hpp"

namespace sonde::ui::test {
namespace {

class GripBoxTest : public testing::Test {
 protected:
  void SetUp() override { need_application(); }
  static QPushButton* button(GripBox& box, const NamedGrip& named) {
    return box.findChild<QPushButton*>(QString::fromStdString("grip_" + std::string(named.name)));
  }
  static std::vector<SliderRow*> rows(GripBox& box) {
    std::vector<SliderRow*> out;
    for (QWidget* each : box.findChildren<QWidget*>())
      if (auto* row = dynamic_cast<SliderRow*>(each)) out.push_back(row);
    return out;
  }
};

TEST_F(GripBoxTest, a_named_grip_sets_every_slider_and_its_button_alone_is_pressed) {
  GripBox box(nullptr);
  std::optional<SimulatedGrip> told;
  QObject::connect(&box, &GripBox::changed, [&](const SimulatedGrip& grip) { told = grip; });
  for (const NamedGrip& named : named_grips()) {
    button(box, named)->click();
    ASSERT_TRUE(told);
    ASSERT_EQ(rows(box).size(), grip_settings().size());
    EXPECT_TRUE(*told == named.grip) << named.name;
    for (const NamedGrip& other : named_grips())
      EXPECT_EQ(button(box, other)->isChecked(), other.grip == named.grip) << other.name;
    for (const SliderRow* row : rows(box))
      EXPECT_DOUBLE_EQ(row->value(), get(named.grip, row->setting().key)) << named.name;
  }
}

TEST_F(GripBoxTest, a_moved_slider_is_a_grip_without_a_name) {
  GripBox box(nullptr);
  std::optional<SimulatedGrip> told;
  QObject::connect(&box, &GripBox::changed, [&](const SimulatedGrip& grip) { told = grip; });
  button(box, named_grips()[0])->click();
  SliderRow* const row = rows(box).front();
  const double before = row->value();
  emit row->changed(row->setting().maximum * 0.7);
  ASSERT_TRUE(told);
  EXPECT_NE(get(*told, row->setting().key), before);
  for (const NamedGrip& named : named_grips()) EXPECT_FALSE(button(box, named)->isChecked());
}

}  // namespace
}  // namespace sonde::ui::test
