// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/format.hpp"

#include <gtest/gtest.h>

#include <QTextDocument>
#include <QTextDocumentFragment>
#include <numbers>

#include "engine/body/body.hpp"

namespace sonde::ui {
namespace {

TEST(Format, an_angle_below_a_millionth_of_a_degree_is_none) {
  constexpr double degree = std::numbers::pi / 180;
  EXPECT_EQ(angle_text(9e-7 * degree), "0°");
  EXPECT_EQ(angle_text(-9e-7 * degree), "0°");
  EXPECT_EQ(angle_text(2e-6 * degree), "2e-06°");
  EXPECT_EQ(angle_text(12.34 * degree), "12.3°");
  EXPECT_EQ(angle_text(-0.5 * degree), "-0.500°");
}

// Reference: Qt's own reading of it as markup.
TEST(Format, a_tooltip_shows_what_a_text_says_to_the_letter) {
  const QString plain = QStringLiteral("nut&bolt <b>2</b> &lt;\n3 < 4 & 5 > 4");
  const QString tip = tooltip_of(plain);
  EXPECT_TRUE(Qt::mightBeRichText(tip));
  EXPECT_EQ(QTextDocumentFragment::fromHtml(tip).toPlainText(), plain);
  EXPECT_TRUE(tooltip_of({}).isEmpty()) << "none at all";
}

TEST(Format, components_have_the_decimals_of_their_length) {
  EXPECT_EQ(components_text({1.2345, -0.0444, 3e-9}), "1.23, -0.04, 0");
  EXPECT_EQ(components_text({-3e-9, 0.0123, 0}), "0, 0.0123, 0");
  EXPECT_EQ(components_text({123.4, 0, -5}), "123, 0, -5");
  EXPECT_EQ(components_text({0, 0, 0}), "0, 0, 0");
}

TEST(Format, a_length_is_zero_only_where_it_is) {
  EXPECT_EQ(LengthUnit(0.5).text(1e-6), QStringLiteral("0.0010 mm"));
  EXPECT_EQ(LengthUnit(0.5).text(2.34e-4), QStringLiteral("0.23 mm"));
  EXPECT_EQ(LengthUnit(0.05).text(-4.27e-8), QStringLiteral("-0.000043 mm"));
  EXPECT_EQ(LengthUnit(0.05).text(3.14e-11), QStringLiteral("3.1e-08 mm"));
  EXPECT_EQ(LengthUnit(0.05).text(9.96e-8), QStringLiteral("0.000100 mm"));
  EXPECT_EQ(LengthUnit(0.05).text(-3e-12), QStringLiteral("0.000 mm")) << "rounding";
  EXPECT_EQ(LengthUnit(0.05).text(0.0), QStringLiteral("0.000 mm"));
  EXPECT_EQ(LengthUnit(40).text(1e-6), QStringLiteral("1.0e-06 m"));
  EXPECT_EQ(LengthUnit(2e-5).text(1e-10), QStringLiteral("0.00010 µm"));
}

TEST(Format, a_point_has_one_unit) {
  EXPECT_EQ(LengthUnit(0.05).text(Vec3(1e-9, -1e-9, -0.5)), "0.000, 0.000, -500.000 mm");
  EXPECT_EQ(LengthUnit(0.05).text(Vec3(1e-3, -2e-4, 0)), "1.000, -0.200, 0.000 mm");
}

TEST(Format, the_name_of_a_body_does_not_turn_the_words_beside_it) {
  Body body;
  body.name = "шайба 座金 \u202eabc\n.ply";
  EXPECT_EQ(short_name(body), QStringLiteral("шайба 座金 abc\\x0a"));
  body.name = "برغي";
  EXPECT_EQ(short_name(body), QStringLiteral("برغي"));
}

/// What is said after the name has room, and revisions, which stand at the end, are told apart.
TEST(Format, of_a_long_name_both_ends_are_left) {
  Body body;
  body.name = "housing of the bearing for the second stage, revision 14 (final).stl";
  EXPECT_EQ(short_name(body), QStringLiteral("housing of the bearing f…sion 14 (final)"));
  EXPECT_EQ(short_name(body).size(), 40);
  body.name = std::string(23, 'a');
  for (int i = 0; i < 20; ++i) body.name += "𝔸";  // two units of UTF-16 each
  EXPECT_FALSE(short_name(body).toUtf8().contains('?')) << "no half letters";
}

TEST(Format, of_a_name_only_the_ending_of_a_mesh_file_is_left_out) {
  Body body;
  const auto shown = [&](const char* name) {
    body.name = name;
    return short_name(body);
  };
  EXPECT_EQ(shown("M3.5 screw"), QStringLiteral("M3.5 screw"));
  EXPECT_EQ(shown("M3.5"), QStringLiteral("M3.5"));
  EXPECT_EQ(shown("M3.5.STL"), QStringLiteral("M3.5"));
  EXPECT_EQ(shown("/home/v1.2/M3.5 nut.stl"), QStringLiteral("M3.5 nut"));
  EXPECT_EQ(shown("gear 1:2.5"), QStringLiteral("gear 1:2.5"));
  EXPECT_EQ(shown("seat 1/2.5"), QStringLiteral("seat 1/2.5"));
  EXPECT_EQ(shown("pair.v2.stl:12"), QStringLiteral("pair.v2:12")) << "a component of a file";
  EXPECT_EQ(shown("pair:12"), QStringLiteral("pair:12"));
}

TEST(Format, lengths_read_well) {
  EXPECT_EQ(LengthUnit(0.05).text(0.0012346), QStringLiteral("1.235 mm"));
  EXPECT_EQ(LengthUnit(5).name(), QStringLiteral("m"));
  EXPECT_EQ(LengthUnit(1e-4).name(), QStringLiteral("µm"));
  EXPECT_EQ(number(12.345), QStringLiteral("12.3"));
  EXPECT_EQ(number(0.012345), QStringLiteral("0.0123"));
  EXPECT_EQ(round_down_125(0.037), 0.02);
  EXPECT_EQ(round_down_125(5), 5);
}

}  // namespace
}  // namespace sonde::ui
