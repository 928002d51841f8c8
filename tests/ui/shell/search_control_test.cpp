// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/search_control.hpp"

#include <optional>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui::test {
namespace {

/// Beside a window whose own control wants no search: nothing shows what is found.
class SearchControlTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    open_cubes();
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) dock->hide();
    for (const Layer each : {Layer::nearest, Layer::straight, Layer::bound})
      window->viewport().set_shown(each, false);
    wait(200);
    searches.emplace(window->viewport(), window->history());
    clock.start();
  }
  bool finds() {
    return wait_until([this] {
      frame(true);
      return searches->newest().has_value();
    });
  }
  void frame(bool wanted) {
    searches->frame(*window->session(), shown().separation, clock.elapsed(), wanted);
  }
  std::optional<SearchControl> searches;
  QElapsedTimer clock;
};

TEST_F(SearchControlTest, what_is_found_is_of_the_pose_that_was_asked_about) {
  EXPECT_FALSE(searches->newest());
  ASSERT_TRUE(finds());
  EXPECT_TRUE(same_pose(searches->newest()->device, shown().separation.device));
  ASSERT_TRUE(searches->newest()->nearest);
  EXPECT_GT(searches->newest()->nearest->depth, 0);
}

TEST_F(SearchControlTest, once_it_is_not_wanted_nothing_is_known) {
  ASSERT_TRUE(finds());
  frame(false);
  EXPECT_FALSE(searches->newest());
  EXPECT_TRUE(finds()) << "the probe has not moved: what was found still holds";
}

TEST_F(SearchControlTest, in_a_pause_nothing_is_asked_for) {
  window->set_paused(true);
  for (int i = 0; i < 20; ++i) {
    frame(true);
    wait(20);
  }
  EXPECT_FALSE(searches->newest());
}

TEST_F(SearchControlTest, it_is_drawn_in_any_of_three_layers) {
  EXPECT_FALSE(searches->is_drawn());
  for (const Layer each : {Layer::nearest, Layer::straight, Layer::bound}) {
    window->viewport().set_shown(each, true);
    EXPECT_TRUE(searches->is_drawn());
    window->viewport().set_shown(each, false);
  }
}

}  // namespace
}  // namespace sonde::ui::test
