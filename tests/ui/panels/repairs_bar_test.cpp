// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/repairs_bar.hpp"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>
#include <QToolButton>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/elided_label.hpp"

namespace sonde::ui::test {
namespace {

class RepairsBarTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    bar = std::make_unique<RepairsBar>(nullptr);
    bar->show();
  }
  template <class T>
  T* find(const char* name) const {
    T* found = bar->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  QToolButton* button(const char* name) const { return find<QToolButton>(name); }
  static RepairsRow row() {
    RepairsRow out;
    out.name = "gear<2>";
    out.text = "2 openings closed";
    out.in_full = "2 openings closed by 9 triangles.";
    return out;
  }

  std::unique_ptr<RepairsBar> bar;
};

TEST_F(RepairsBarTest, each_body_has_a_line_as_long_as_there_is_something_to_say) {
  bar->show_row(RepairsBar::probe, row());
  EXPECT_EQ(find<ElidedLabel>("mended_probe")->text(), "gear<2>: 2 openings closed");
  EXPECT_TRUE(find<ElidedLabel>("mended_probe")->isVisible());
  EXPECT_FALSE(find<ElidedLabel>("mended_fixed")->isVisible());
  const QString tip = find<ElidedLabel>("mended_probe")->toolTip();
  EXPECT_TRUE(tip.startsWith("<p>Probe gear&lt;2&gt;: ")) << "a name is no markup";
  EXPECT_TRUE(tip.endsWith("9 triangles.</p>"));
  bar->show_row(RepairsBar::probe, {});
  EXPECT_FALSE(find<ElidedLabel>("mended_probe")->isVisible());
}

TEST_F(RepairsBarTest, offers_what_can_be_done_and_no_more) {
  RepairsRow line = row();
  bar->show_row(RepairsBar::fixed, line);
  for (const char* name : {"mended_fixed_show", "mended_fixed_repair", "mended_fixed_close"})
    EXPECT_FALSE(button(name)->isVisible()) << name;
  line.can_show = line.can_be_as_in_file = line.can_close = true;
  bar->show_row(RepairsBar::fixed, line);
  for (const char* name : {"mended_fixed_show", "mended_fixed_repair", "mended_fixed_close"})
    EXPECT_TRUE(button(name)->isVisible()) << name;
  EXPECT_EQ(button("mended_fixed_repair")->text(), "As in the file");
  line.can_be_as_in_file = false;
  line.as_in_file = true;
  bar->show_row(RepairsBar::fixed, line);
  EXPECT_EQ(button("mended_fixed_repair")->text(), "Mend it");
}

TEST_F(RepairsBarTest, a_button_tells_of_which_body_and_which_way) {
  QStringList told;
  QObject::connect(bar.get(), &RepairsBar::show_wanted,
                   [&](std::size_t body) { told << QStringLiteral("show %1").arg(body); });
  QObject::connect(bar.get(), &RepairsBar::close_wanted,
                   [&](std::size_t body) { told << QStringLiteral("close %1").arg(body); });
  QObject::connect(bar.get(), &RepairsBar::repair_wanted, [&](std::size_t body, bool as_in_file) {
    told << QStringLiteral("%1 %2").arg(as_in_file ? "raw" : "mend").arg(body);
  });
  QObject::connect(bar.get(), &RepairsBar::put_away, [&] { told << "away"; });
  RepairsRow line = row();
  line.can_show = line.can_be_as_in_file = line.can_close = true;
  bar->show_row(RepairsBar::probe, line);
  bar->show_row(RepairsBar::fixed, line);
  button("mended_fixed_show")->click();
  button("mended_probe_close")->click();
  button("mended_probe_repair")->click();
  line.as_in_file = true;
  bar->show_row(RepairsBar::probe, line);
  button("mended_probe_repair")->click();
  button("mended_away")->click();
  EXPECT_EQ(told, QStringList({"show 1", "close 0", "raw 0", "mend 0", "away"}));
}

TEST_F(RepairsBarTest, enter_and_space_press_a_button_and_other_keys_do_not) {
  int shown = 0;
  QObject::connect(bar.get(), &RepairsBar::show_wanted, [&](std::size_t) { ++shown; });
  RepairsRow line = row();
  line.can_show = true;
  bar->show_row(RepairsBar::probe, line);
  QToolButton* show = button("mended_probe_show");
  for (const auto key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) QTest::keyClick(show, key);
  EXPECT_EQ(shown, 3);
  QTest::keyClick(show, Qt::Key_S);
  QTest::keyClick(show, Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(shown, 3);
}

TEST_F(RepairsBarTest, the_place_that_is_looked_at_is_counted_until_the_body_changes) {
  RepairsRow line = row();
  line.can_show = true;
  bar->set_key("M");
  bar->show_row(RepairsBar::probe, line);
  EXPECT_TRUE(button("mended_probe_show")->toolTip().endsWith("(M)"));
  EXPECT_FALSE(find<QLabel>("mended_probe_places")->isVisible());
  bar->show_places(RepairsBar::probe, "1 of 7", "the largest first");
  EXPECT_EQ(find<QLabel>("mended_probe_places")->text(), "1 of 7");
  EXPECT_TRUE(find<QLabel>("mended_probe_places")->isVisible());
  bar->show_row(RepairsBar::probe, line);
  EXPECT_FALSE(find<QLabel>("mended_probe_places")->isVisible());
}

}  // namespace
}  // namespace sonde::ui::test
