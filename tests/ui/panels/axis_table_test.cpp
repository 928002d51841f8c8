// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/axis_table.hpp"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <optional>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

class AxisTableTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    table.emplace(nullptr);
    QObject::connect(&*table, &AxisTable::changed, [this](const AxisMap& axes) { told = axes; });
  }
  template <class T>
  T* find(const char* name) {
    return table->findChild<T*>(name);
  }
  std::optional<AxisTable> table;
  std::optional<AxisMap> told;
};

TEST_F(AxisTableTest, a_change_of_one_axis_is_told_with_the_others_as_they_were) {
  AxisMap axes;
  axes.axes[1] = {.source = 2, .inverted = true, .gain = 0.5, .dead_zone = 0.1, .expo = 0.25};
  table->show_axes(axes, true);
  EXPECT_FALSE(told) << "what is shown is not told";
  find<QCheckBox>("axis_x_inverted")->click();
  ASSERT_TRUE(told);
  EXPECT_TRUE(told->axes[0].inverted);
  EXPECT_EQ(told->axes[1].source, 2);
  EXPECT_TRUE(told->axes[1].inverted);
  EXPECT_EQ(told->axes[1].gain, 0.5);
  EXPECT_EQ(told->axes[1].dead_zone, 0.1);
  EXPECT_EQ(told->axes[1].expo, 0.25);
  find<QComboBox>("axis_z_from")->setCurrentIndex(0);
  EXPECT_EQ(told->axes[2].source, 0);
}

TEST_F(AxisTableTest, positions_have_no_dead_zone_and_no_curve) {
  table->show_axes({}, false);
  EXPECT_FALSE(find<TypedValue>("axis_x_dead_zone")->isEnabled());
  EXPECT_FALSE(find<TypedValue>("axis_x_expo")->isEnabled());
  EXPECT_TRUE(find<TypedValue>("axis_x_gain")->isEnabled());
  table->show_axes({}, true);
  EXPECT_TRUE(find<TypedValue>("axis_x_expo")->isEnabled());
}

}  // namespace
}  // namespace sonde::ui::test
