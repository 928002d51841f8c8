// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/label_layout.hpp"

#include <gtest/gtest.h>

#include <QLineF>
#include <random>

namespace sonde::ui {
namespace {

constexpr QSizeF view(640, 700);
const QRectF legend(14, 14, 260, 130), hint(14, 620, 612, 66);

/// Does a line run through a box? By where it crosses the sides: not as the layout samples it.
bool crosses(const QRectF& box, const QLineF& line) {
  const QPointF a = box.topLeft(), b = box.topRight(), c = box.bottomRight(), d = box.bottomLeft();
  for (const QLineF& side : {QLineF(a, b), QLineF(b, c), QLineF(c, d), QLineF(d, a)})
    if (side.intersects(line, nullptr) == QLineF::BoundedIntersection) return true;
  return box.contains(line.p1());
}

TEST(LabelLayout, covers_nothing_that_there_is_room_beside) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(60, 580), y(160, 600), reach(-80, 80), wide(40, 160);
  for (int round = 0; round < 500; ++round) {
    std::vector<LabelToPlace> labels;
    for (int i = 0; i < 3; ++i) {
      const QPointF tip(x(random), y(random));
      const QPointF foot = tip + QPointF(reach(random), reach(random));
      labels.push_back({tip, {wide(random), 20}, QPolygonF(QVector<QPointF>{foot, tip})});
    }
    const std::vector<QRectF> boxes = place_labels(labels, {legend, hint}, view);
    ASSERT_EQ(boxes.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_TRUE(QRectF({0, 0}, view).contains(boxes[i]));
      EXPECT_FALSE(boxes[i].intersects(legend)) << round;
      EXPECT_FALSE(boxes[i].intersects(hint)) << round;
      for (std::size_t j = 0; j < 3; ++j) {
        if (j != i) {
          EXPECT_FALSE(boxes[i].intersects(boxes[j])) << round;
        }
        // Corners are cut between the samples: by less than two pixels.
        EXPECT_FALSE(crosses(boxes[i].adjusted(2, 2, -2, -2),
                             QLineF(labels[j].stroke[0], labels[j].stroke[1])))
            << round;
      }
    }
  }
}

TEST(LabelLayout, what_is_not_in_the_view_has_no_label) {
  const QSizeF view(400, 300), text(60, 20);
  const std::vector<LabelToPlace> labels{
      {{-40, 100}, text},
      {{450, 350}, text, QPolygonF(QVector<QPointF>{{430, 310}, {450, 350}})},
      {{-40, 100},
       text,
       QPolygonF(QVector<QPointF>{{30, 100}, {-40, 100}})},  // its line begins in the view
      {{-40, -40},
       text,
       QPolygonF(QVector<QPointF>{{-40, 500}, {800, -340}})}};  // or goes through it
  const std::vector<QRectF> boxes = place_labels(labels, {}, view);
  ASSERT_EQ(boxes.size(), 4u);
  EXPECT_TRUE(boxes[0].isEmpty());
  EXPECT_TRUE(boxes[1].isEmpty());
  EXPECT_TRUE(QRectF({}, view).contains(boxes[2])) << "where its end is";
  EXPECT_FALSE(boxes[2].isEmpty());
  EXPECT_FALSE(boxes[3].isEmpty());
}

TEST(LabelLayout, stays_inside_a_view_with_no_room) {
  const std::vector<LabelToPlace> labels(4, LabelToPlace{{20, 20}, {60, 20}});
  for (const QRectF& box : place_labels(labels, {QRectF(0, 0, 80, 80)}, {80, 80}))
    EXPECT_TRUE(QRectF(0, 0, 80, 80).contains(box));
}

}  // namespace
}  // namespace sonde::ui
