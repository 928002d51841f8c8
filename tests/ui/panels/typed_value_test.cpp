// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/typed_value.hpp"

#include <gtest/gtest.h>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

constexpr Setting stiffness{"k", "Stiffness", "N/m", 10, 1e5, 500, true, "A stiffness."};
constexpr Setting ratio{"ratio", "Ratio", "", 0, 2, 1, false, "A ratio."};

class TypedValueTest : public testing::Test {
 protected:
  void SetUp() override { need_application(); }
  static QValidator::State state(const TypedValue& box, QString text) {
    int position = 0;
    return box.validate(text, position);
  }
};

TEST_F(TypedValueTest, shows_its_unit_and_reads_either_decimal_point) {
  TypedValue box(stiffness, nullptr);
  box.setValue(1234.4);
  EXPECT_EQ(box.text(), "1234 N/m") << "four digits are enough to read";
  EXPECT_EQ(box.value(), 1234.4);
  EXPECT_EQ(box.valueFromText("250,5 N/m"), 250.5);
  EXPECT_EQ(box.valueFromText("2e3"), 2000);
}

TEST_F(TypedValueTest, a_step_is_a_tenth_of_a_gain_and_a_hundredth_of_a_range) {
  TypedValue box(stiffness, nullptr), other(ratio, nullptr);
  box.setValue(500);
  box.stepBy(1);
  EXPECT_NEAR(box.value(), 550, 1e-6);
  other.setValue(1);
  other.stepBy(-3);
  EXPECT_NEAR(other.value(), 0.94, 1e-9);
}

TEST_F(TypedValueTest, half_a_number_may_become_one_and_a_word_may_not) {
  TypedValue box(stiffness, nullptr);
  EXPECT_EQ(state(box, "500 N/m"), QValidator::Acceptable);
  EXPECT_EQ(state(box, "5"), QValidator::Intermediate) << "below the least, so far";
  EXPECT_EQ(state(box, "2e"), QValidator::Intermediate);
  EXPECT_EQ(state(box, "stiff"), QValidator::Invalid);
}

}  // namespace
}  // namespace sonde::ui::test
