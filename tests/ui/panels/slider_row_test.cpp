// SPDX-License-Identifier: GPL-3.0-or-later
// Reference: the closed form of either scale.
#include "ui/panels/slider_row.hpp"

#include <gtest/gtest.h>

#include <QSlider>
#include <cmath>
#include <vector>

#include "tests/ui/window_fixture.hpp"
#include "ui/panels/typed_value.hpp"

namespace sonde::ui::test {
namespace {

constexpr Setting logarithmic{"gain", "Gain", "N/m", 10, 1e5, 1000, true, "A gain."};
constexpr Setting linear{"share", "Share", "", -1, 1, 0, false, "A share."};
constexpr Setting whole{"count", "Count", "", 0, 7, 2, false, "A count.", true};

class SliderRowTest : public testing::Test {
 protected:
  void SetUp() override { need_application(); }
  static QSlider& slider(const SliderRow& row) { return *row.findChild<QSlider*>(); }
  static TypedValue& typed(const SliderRow& row) { return *row.findChild<TypedValue*>(); }
};

TEST_F(SliderRowTest, the_middle_of_a_logarithmic_slider_is_the_geometric_mean) {
  SliderRow row(logarithmic, nullptr);
  std::vector<double> told;
  QObject::connect(&row, &SliderRow::changed, [&](double value) { told.push_back(value); });
  slider(row).setValue(slider(row).maximum() / 2);
  ASSERT_EQ(told.size(), 0u) << "it stood there: 1000 is the mean of 10 and 1e5";
  slider(row).setValue(0);
  slider(row).setValue(slider(row).maximum());
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NEAR(told[0], 10, 1e-9);
  EXPECT_NEAR(told[1], 1e5, 1e-4);
}

TEST_F(SliderRowTest, a_typed_value_moves_the_slider_and_is_told_once) {
  SliderRow row(linear, nullptr);
  std::vector<double> told;
  QObject::connect(&row, &SliderRow::changed, [&](double value) { told.push_back(value); });
  typed(row).setValue(0.5);
  EXPECT_EQ(told, std::vector<double>{0.5});
  EXPECT_EQ(slider(row).value(), slider(row).maximum() * 3 / 4);
  EXPECT_EQ(row.value(), 0.5) << "and stays as exact as it was typed";
}

TEST_F(SliderRowTest, what_is_shown_is_not_told) {
  SliderRow row(linear, nullptr);
  QObject::connect(&row, &SliderRow::changed, [](double) { ADD_FAILURE(); });
  row.set_value(-0.25);
  EXPECT_EQ(row.value(), -0.25);
  EXPECT_EQ(typed(row).value(), -0.25);
}

TEST_F(SliderRowTest, a_whole_number_has_no_fraction_wherever_the_slider_stands) {
  SliderRow row(whole, nullptr);
  EXPECT_EQ(row.value(), 2);
  for (int position = 0; position <= slider(row).maximum(); position += 37) {
    slider(row).setValue(position);
    EXPECT_EQ(row.value(), std::round(row.value()));
  }
}

}  // namespace
}  // namespace sonde::ui::test
