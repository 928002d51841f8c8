// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/last_second_box.hpp"

#include <gtest/gtest.h>

#include <QLabel>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

class LastSecondBoxTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    box = std::make_unique<LastSecondBox>();
  }
  QString text(const char* name) const {
    const auto* label = box->findChild<QLabel*>(name);
    EXPECT_TRUE(label) << name;
    return label ? label->text() : QString();
  }
  std::unique_ptr<LastSecondBox> box;
};

TEST_F(LastSecondBoxTest, it_has_its_figures_and_what_is_wrong_in_them) {
  Buzz buzz;
  buzz.energy = -0.0125;
  box->show_buzz(buzz, 1);
  EXPECT_EQ(text("chatter_value"), "none: no force moves a mouse");
  EXPECT_EQ(text("energy_value"), "-12.5 mJ");
  EXPECT_EQ(text("rendered_gains"), "as set");
  buzz.loop = true;
  box->show_buzz(buzz, 2);
  EXPECT_EQ(text("chatter_value"), "none");
  buzz.chatter = {.force = 0.25, .frequency = 90, .acceleration = 0.5 * felt_acceleration};
  box->show_buzz(buzz, 3);
  EXPECT_EQ(text("chatter_value"), "0.250 N at 90.0 Hz");
  buzz.chatter.acceleration = felt_acceleration;
  buzz.capped = true;
  box->show_buzz(buzz, 4);
  EXPECT_TRUE(text("chatter_value").contains("0.250 N at 90.0 Hz, buzzing"));
  EXPECT_TRUE(text("rendered_gains").contains("as much as the device bears"));
  buzz.waiting = true;
  buzz.rendered.now.k = 345;
  box->show_buzz(buzz, 5);
  EXPECT_TRUE(text("rendered_gains").contains("unstable in this contact"));
  EXPECT_TRUE(text("rendered_gains").contains("k 345 N/m; those set wait"));
  box->clear_history();
  for (const char* name : {"chatter_value", "energy_value", "rendered_gains"})
    EXPECT_EQ(text(name), "–") << name;
}

}  // namespace
}  // namespace sonde::ui::test
