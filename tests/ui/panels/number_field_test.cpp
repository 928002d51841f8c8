// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/number_field.hpp"

#include <gtest/gtest.h>

#include <QKeyEvent>
#include <cmath>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

class NumberFieldTest : public testing::Test {
 protected:
  void SetUp() override { need_application(); }
  static bool takes(int key, Qt::KeyboardModifiers with = Qt::NoModifier) {
    NumberField field;
    QKeyEvent event(QEvent::ShortcutOverride, key, with);
    event.ignore();
    QApplication::sendEvent(&field, &event);
    return event.isAccepted();
  }
};

TEST_F(NumberFieldTest, a_point_and_a_comma_are_the_same_and_what_is_none_is_not_a_number) {
  NumberField field;
  for (const char* typed : {"-12.5", " -12,5 ", "-1.25e1"}) {
    field.setText(typed);
    EXPECT_EQ(field.number(), -12.5) << typed;
  }
  for (const char* typed : {"", "12 mm", "1.2.3", "0x10", "1,000.5"}) {
    field.setText(typed);
    EXPECT_TRUE(std::isnan(field.number())) << typed;
  }
}

TEST_F(NumberFieldTest, what_is_shown_is_read_back_and_rounding_is_zero) {
  NumberField field;
  for (const double value : {0.0, 1.0, -2.5e-7, 123456.7, 1e12}) {
    field.show_number(value);
    EXPECT_DOUBLE_EQ(field.number(), value);
  }
  EXPECT_EQ(number_in_field(-1e-17), "0");
  EXPECT_EQ(number_in_field(1.0 / 3), "0.3333333");
}

TEST_F(NumberFieldTest, letters_stay_commands_of_the_window) {
  EXPECT_FALSE(takes(Qt::Key_F));
  EXPECT_FALSE(takes(Qt::Key_Space));
  EXPECT_TRUE(takes(Qt::Key_E)) << "2e3 is a number";
  EXPECT_TRUE(takes(Qt::Key_5));
  EXPECT_TRUE(takes(Qt::Key_A, Qt::ControlModifier)) << "all is selected";
}

}  // namespace
}  // namespace sonde::ui::test
