// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/hint_view.hpp"

#include <algorithm>

#include "tests/ui/views/hint_fixture.hpp"

namespace sonde::ui::test {
namespace {

const QColor vivid(20, 250, 60);

/// With everything that it can show.
void fill(HintView& hints) {
  hints.set_legend({{Qt::red, "the probe"}, {Qt::blue, "the fixed body, of some length"}});
  hints.set_ruler(120, "20 mm");
  hints.set_banner(HintView::stopped_banner());
  hints.set_scale({"gap, mm", {Qt::yellow, Qt::blue}, {"0", "1", "2"}});
  hints.set_triad({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
}

TEST_F(HintViewTest, nothing_that_it_shows_lies_on_anything_else) {
  fill(*hints);
  for (const QSize& size : {QSize(800, 600), QSize(480, 640), QSize(1600, 500)}) {
    hints->resize(size);
    const std::vector<QRectF> boxes = hints->boxes();
    EXPECT_EQ(boxes.size(), 6u) << "legend, ruler, banner, scale, axes, hint";
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_TRUE(QRectF(hints->rect()).contains(boxes[i])) << size.width() << ": " << i;
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_FALSE(boxes[i].intersects(boxes[j])) << size.width() << ": " << i << ' ' << j;
    }
  }
}

TEST_F(HintViewTest, areas_are_clear_of_legend_banner_and_hint_and_grow_when_these_go) {
  fill(*hints);
  const std::vector<QRectF> before = hints->clear_areas();
  const QRectF legend = hints->boxes()[0];
  for (const QRectF& area : before) {
    EXPECT_FALSE(area.intersects(legend));
    EXPECT_GT(area.height(), 100);
  }
  hints->fade();
  EXPECT_EQ(hints->boxes().size(), 4u) << "their room is free at once";
  EXPECT_GT(hints->clear_areas()[0].height(), before[0].height());
  hints->set_hint_visible(true);
  hints->set_legend_visible(true);
  EXPECT_EQ(hints->clear_areas(), before);
}

/// As the window's first drag lets them go: what was not on show does not come for that.
TEST_F(HintViewTest, what_gave_way_is_not_seen_while_the_rest_fades) {
  hints->resize(480, 355);
  hints->set_legend(std::vector<LegendLine>(7, {Qt::red, "a fixed body of several parts, solid"}));
  const QRect below(0, 240, 480, 115);
  const QImage before = sheet().copy(below);
  hints->fade();
  EXPECT_EQ(sheet().copy(below), before);
}

/// In a small view they give way to the bodies, the hint first, unless they were asked for.
TEST_F(HintViewTest, hint_and_legend_leave_the_bodies_about_half_of_the_view) {
  std::vector<LegendLine> legend;
  for (int i = 0; i < 7; ++i) legend.push_back({Qt::red, "a fixed body of several parts, solid"});
  hints->set_legend(legend);
  const auto shown_in = [&](const QSize& size) {
    hints->resize(size);
    const std::vector<QRectF> areas = hints->clear_areas();
    const auto part = [&](const QRectF& area) {
      return area.width() * area.height() / (size.width() * size.height());
    };
    const double most = std::max(part(areas[0]), part(areas[1]));
    EXPECT_GT(most, 0.4) << size.width() << " x " << size.height();
    return hints->boxes().size();
  };
  EXPECT_EQ(shown_in({800, 600}), 3u) << "legend, axes, hint";
  EXPECT_EQ(shown_in({480, 355}), 2u) << "without the hint";
  EXPECT_EQ(shown_in({300, 220}), 1u) << "the axes alone";
  hints->set_insists(true);
  EXPECT_EQ(hints->boxes().size(), 3u);
}

TEST_F(HintViewTest, the_name_of_a_body_may_be_longer_than_the_view_is_wide) {
  hints->set_legend({{Qt::red, QString(300, 'x') + ", solid"}, {Qt::blue, "contacts"}});
  const QImage image = sheet();
  const QRectF plate = hints->boxes()[0];
  EXPECT_TRUE(QRectF(hints->rect()).contains(plate));
  EXPECT_GT(plate.width(), 0.8 * hints->width());
}

/// The longest row of pixels of the text's colour is the bar.
TEST_F(HintViewTest, the_ruler_is_as_many_pixels_long_as_it_says) {
  hints->set_hint_visible(false);
  hints->set_ruler(137, "50 mm");
  const QImage image = sheet();
  const QColor text = hints->palette().color(QPalette::WindowText);
  int longest = 0;
  for (int y = 0; y < image.height(); ++y) {
    int run = 0;
    for (int x = 0; x < image.width(); ++x) {
      const QColor at(image.pixel(x, y));
      run = std::abs(at.red() - text.red()) + std::abs(at.blue() - text.blue()) < 40 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_NEAR(longest, 137, 3);
  hints->set_ruler(0, {});
  EXPECT_TRUE(pixels(text).empty());
}

TEST_F(HintViewTest, a_label_is_written_beside_its_point_in_its_colour) {
  hints->set_hint_visible(false);
  EXPECT_TRUE(pixels(vivid, 100).empty());
  PlacedLabel label;
  label.at = QPointF(400, 300);
  label.text = "5.00 N";
  label.colour = vivid;
  hints->set_labels({label});
  const QRect seen = around(pixels(vivid, 100));
  ASSERT_FALSE(seen.isEmpty());
  EXPECT_TRUE(QRect(320, 240, 160, 120).contains(seen));
  label.note.course = {0, 1, 0, 1};
  hints->set_labels({label});
  EXPECT_GT(around(pixels(vivid, 100)).width(), 140) << "a curve of 150 pixels below";
  label.text.clear();
  hints->set_labels({label});
  EXPECT_TRUE(pixels(vivid, 100).empty()) << "a line alone says nothing";
}

TEST_F(HintViewTest, a_scale_begins_below_with_its_first_colour) {
  hints->set_hint_visible(false);
  hints->set_scale({"gap, mm", {QColor(250, 0, 0), QColor(0, 0, 250)}, {"0", "1", "2"}});
  const QRect first = around(pixels(QColor(250, 0, 0))), last = around(pixels(QColor(0, 0, 250)));
  ASSERT_FALSE(first.isEmpty());
  ASSERT_FALSE(last.isEmpty());
  EXPECT_GT(first.top(), last.bottom());
  EXPECT_EQ(first.left(), last.left());
  hints->set_scale({});
  EXPECT_EQ(hints->boxes().size(), 1u) << "the corner of the axes alone";
  EXPECT_TRUE(pixels(QColor(250, 0, 0)).empty());
}

}  // namespace
}  // namespace sonde::ui::test
