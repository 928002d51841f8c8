// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/repairs_text.hpp"

#include <gtest/gtest.h>

#include <QSet>
#include <QStringList>

#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui {
namespace {

TEST(RepairsText, counts_what_was_done_in_a_few_words) {
  Body body;
  EXPECT_EQ(repairs_in_brief(body), "");
  body.repairs.turned_triangles = 1;
  EXPECT_EQ(repairs_in_brief(body), "1 triangle turned");
  body.repairs.turned_triangles = 3;
  body.repairs.caps = 2;
  body.repairs.joined = 4;
  body.repairs.on_edges = 5;
  EXPECT_EQ(repairs_in_brief(body), "3 triangles turned, 2 openings closed, 9 corners joined");
}

TEST(RepairsText, a_body_of_which_every_part_was_turned_was_inside_out) {
  Body body;
  body.repairs.parts = 2;
  body.repairs.turned_parts = 1;
  EXPECT_EQ(repairs_in_brief(body), "1 part was inside out");
  body.repairs.turned_parts = 2;
  EXPECT_EQ(repairs_in_brief(body), "was inside out");
}

TEST(RepairsText, that_parts_overlap_changes_no_mesh) {
  Body body;
  body.repairs.overlaps = true;
  EXPECT_EQ(repairs_in_brief(body), "");
}

TEST(RepairsText, says_how_open_a_mesh_is_that_could_be_a_solid) {
  Body body;
  body.why = "a surface";
  body.repairs.could_be_solid = true;
  body.repairs.widest_mouth = 0.25;
  EXPECT_EQ(repairs_in_brief(body), "could be a solid (open by 25.0 %)");
  const QStringList lines = repairs_in_full(body).split('\n');
  ASSERT_EQ(lines.size(), 2);
  EXPECT_TRUE(lines[0].startsWith("Its widest opening is 25.0 % of what is seen"));
  EXPECT_EQ(lines[1], "a surface.");
}

TEST(RepairsText, says_how_many_parts_stay_open_beside_closed_ones_and_what_then_has_mass) {
  Body body;
  body.why = "2 of 27 parts are closed: their inside counts";
  body.mass_why = "by area: 97 % of the area belongs to open parts";
  body.repairs.parts = 27;
  body.repairs.solid_parts = 2;
  EXPECT_EQ(repairs_in_brief(body), "25 parts stay open");
  EXPECT_TRUE(repairs_in_full(body).endsWith(
      "\nAs a probe it has its mass by area: 97 % of the area belongs to open parts."));
}

/// Of a ball of which one triangle is left out: that triangle alone closes it again.
TEST(RepairsText, of_a_ball_with_an_opening_is_about_that_opening) {
  PolygonSoup ball = sonde::test::icosphere(0.05, 2);
  ball.polygons.pop_back();
  const auto body = sonde::test::body(ball);
  EXPECT_EQ(repairs_in_brief(*body), "1 opening closed");
  const QStringList lines = repairs_in_full(*body).split('\n');
  EXPECT_TRUE(lines[0].startsWith("1 opening closed by 1 triangle of ")) << lines[0].toStdString();
  for (const QString& line : lines) EXPECT_TRUE(line.endsWith('.')) << line.toStdString();
  ASSERT_EQ(body->places.places.size(), 1u);
  EXPECT_EQ(words(body->places.places[0].kind), "opening closed");
}

TEST(RepairsText, every_kind_of_place_has_words_of_its_own) {
  QSet<QString> all;
  for (int kind = 0; kind <= int(RepairKind::seam); ++kind) all << words(RepairKind(kind));
  EXPECT_EQ(all.size(), int(RepairKind::seam) + 1);
  EXPECT_FALSE(all.contains(QString()));
}

}  // namespace
}  // namespace sonde::ui
