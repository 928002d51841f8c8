// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/repairs_notice.hpp"

#include <gtest/gtest.h>

#include <QToolButton>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/elided_label.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui::test {
namespace {

TEST(RepairsNotice, says_in_brief_what_there_is_and_is_empty_else) {
  need_application();
  QAction unfold("What was &mended");
  unfold.setCheckable(true);
  RepairsNotice notice(nullptr);
  notice.set_action(&unfold);
  notice.resize(600, 30);
  notice.show();
  auto* const button = notice.findChild<QToolButton*>("mended_unfold");
  auto* const probe = notice.findChild<ElidedLabel*>("mended_probe_notice");
  auto* const fixed = notice.findChild<ElidedLabel*>("mended_fixed_notice");
  ASSERT_TRUE(button && probe && fixed);
  EXPECT_FALSE(button->isVisible());
  RepairsRow row;
  row.name = "gear<2>";
  row.text = "2 openings closed";
  row.in_full = "2 openings closed by 9 triangles.";
  notice.show_row(RepairsBar::fixed, row);
  EXPECT_TRUE(button->isVisible());
  EXPECT_FALSE(probe->isVisible());
  EXPECT_TRUE(fixed->isVisible());
  EXPECT_EQ(fixed->text(), "2 openings closed");
  EXPECT_EQ(fixed->accessibleName(), "Fixed body gear<2>: 2 openings closed");
  const QString whole = "Fixed body gear<2>: 2 openings closed\n2 openings closed by 9 triangles.";
  EXPECT_EQ(fixed->toolTip(), tooltip_of(whole)) << "a name is no markup";
  button->click();
  EXPECT_TRUE(unfold.isChecked());
  notice.show_row(RepairsBar::fixed, {});
  EXPECT_FALSE(button->isVisible());
  EXPECT_FALSE(fixed->isVisible());
}

}  // namespace
}  // namespace sonde::ui::test
