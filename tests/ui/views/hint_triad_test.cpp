// SPDX-License-Identifier: GPL-3.0-or-later
// The axes in the corner of the view.

#include "tests/ui/views/hint_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

class HintTriadTest : public HintViewTest {
 protected:
  void SetUp() override {
    HintViewTest::SetUp();
    hints->set_hint_visible(false);
  }
  QRect box() const { return hints->boxes().at(0).toAlignedRect(); }
  /// Of what is drawn of an axis: its line and its name.
  QRect seen(const QColor& colour) const { return around(pixels(colour, 40)); }
  static double length(const QRect& line) { return std::max(line.width(), line.height()); }

  const QColor x{235, 90, 90}, y{110, 190, 90}, z{100, 150, 245};
};

TEST_F(HintTriadTest, axes_lead_to_where_they_are_seen) {
  hints->set_triad({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
  const QPoint middle = box().center();
  EXPECT_GT(seen(x).center().x(), middle.x() + 8) << "to the right";
  EXPECT_LT(std::abs(seen(x).center().y() - middle.y()), 8);
  EXPECT_LT(seen(y).center().y(), middle.y() - 8) << "up";
  EXPECT_LT(std::abs(seen(y).center().x() - middle.x()), 8);
  EXPECT_LT(std::abs(seen(z).center().x() - middle.x()), 8) << "to the eye";
  hints->set_triad({-Vec3::UnitX(), -Vec3::UnitY(), -Vec3::UnitZ()});
  EXPECT_LT(seen(x).center().x(), middle.x() - 8);
  EXPECT_GT(seen(y).center().y(), middle.y() + 8);
}

TEST_F(HintTriadTest, an_axis_that_is_seen_aslant_is_shorter) {
  hints->set_triad({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
  const double whole = length(seen(x));
  const Quat turn(Eigen::AngleAxisd(std::acos(0.5), Vec3::UnitY()));
  hints->set_triad({turn * Vec3::UnitX(), Vec3::UnitY(), turn * Vec3::UnitZ()});
  EXPECT_LT(length(seen(x)), 0.8 * whole);
  EXPECT_GT(seen(z).center().x(), box().center().x()) << "it leads to the right now";
}

TEST_F(HintTriadTest, stands_in_the_corner_that_the_legend_leaves) {
  hints->set_triad({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
  EXPECT_LT(box().right(), 400);
  EXPECT_GT(box().top(), 400);
  hints->set_hint_visible(true);
  for (const QRectF& other : hints->boxes())
    EXPECT_FALSE(other != hints->boxes()[0] && other.intersects(hints->boxes()[0]))
        << "above the hint";
  hints->set_hint_visible(false);
  hints->set_legend(std::vector<LegendLine>(40, {Qt::gray, "one of many"}));
  ASSERT_EQ(hints->boxes().size(), 2u);
  EXPECT_GT(hints->boxes()[1].left(), 400) << "in the other one";
}

TEST_F(HintTriadTest, without_a_view_there_are_no_axes) {
  hints->set_triad({Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  for (const QColor& colour : {x, y, z}) EXPECT_TRUE(pixels(colour, 40).empty());
}

}  // namespace
}  // namespace sonde::ui::test
