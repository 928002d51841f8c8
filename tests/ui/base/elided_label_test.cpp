// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/elided_label.hpp"

#include "tests/ui/window_fixture.hpp"

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
  EXPECT_EQ(label.toolTip(), line.toHtmlEscaped());
}

}  // namespace
}  // namespace sonde::ui::test
