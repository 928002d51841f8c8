// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/elided_label.hpp"

#include <algorithm>

#include "tests/ui/window_fixture.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(WindowTest, a_line_without_room_ends_in_dots_and_is_whole_in_the_tooltip) {
  ElidedLabel label;
  const QString line = QStringLiteral("There is a nearer way out, of 3 < 4 mm");
  label.show_text(line);
  label.resize(label.sizeHint());
  EXPECT_EQ(label.shown(), line);
  EXPECT_LE(label.minimumSizeHint().width(), 1) << "the window does not grow with it";
  label.resize(label.width() / 2, label.height());
  EXPECT_TRUE(label.shown().endsWith(QChar(0x2026))) << label.shown().toStdString();
  EXPECT_TRUE(line.startsWith(label.shown().chopped(1)));
  EXPECT_EQ(label.text(), line);
  EXPECT_EQ(label.toolTip(), tooltip_of(line));
}

TEST_F(WindowTest, a_list_without_room_ends_after_a_whole_item) {
  ElidedLabel label;
  label.end_after_items(", ");
  const QStringList items{"2 openings closed", "13 triangles turned", "12984 corners joined"};
  label.show_text(items.join(", "));
  auto fewest = items.size();
  for (int wide = label.sizeHint().width(); wide > 0; --wide) {
    label.resize(wide, 20);
    const QString shown = label.shown();
    if (!shown.startsWith(items[0] + ", ")) break;  // not even the first
    for (const QString& item : shown.split(", "))
      EXPECT_TRUE(items.contains(item) || item == "…") << shown.toStdString();
    fewest = std::min(fewest, shown.split(", ").size());
  }
  EXPECT_EQ(fewest, 2) << "the first, and dots";
  label.resize(label.sizeHint());
  EXPECT_EQ(label.shown(), items.join(", "));
}

}  // namespace
}  // namespace sonde::ui::test
