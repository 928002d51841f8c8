// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/click_taker.hpp"

#include <gtest/gtest.h>

#include "tests/ui/actions/seeing_fixture.hpp"
#include "ui/actions/seeing_control.hpp"

namespace sonde::ui::test {
namespace {

class Waiting : public ClickTaker {
 public:
  bool click(QPointF /*at*/) override {
    ++asked;
    return waits;
  }
  int asked = 0;
  bool waits = false;
};

TEST_F(SeeingTest, clicks_are_first_theirs_who_wait_for_them_in_their_order) {
  Waiting first, second;
  window->seeing().add_taker(first);
  window->seeing().add_taker(second);
  int left = 0;
  QObject::connect(&window->seeing(), &SeeingControl::clicked, [&] { ++left; });
  const QPointF corner(window->viewport().width() - 5.0, 5);  // where nothing is
  click(corner);
  EXPECT_EQ(first.asked, 1);
  EXPECT_EQ(second.asked, 1);
  EXPECT_EQ(left, 1) << "nobody waited";
  first.waits = true;
  click(corner);
  EXPECT_EQ(first.asked, 2);
  EXPECT_EQ(second.asked, 1) << "the first has taken it";
  EXPECT_EQ(left, 1);
}

}  // namespace
}  // namespace sonde::ui::test
