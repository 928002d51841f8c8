// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/clash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "engine/proximity/queries/intersect.hpp"
#include "engine/study/assembly/box_pairs.hpp"
#include "engine/study/assembly/clash_picture.hpp"
#include "engine/study/charts/svg_elements.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

AssemblyPart part(const std::string& name, const PolygonSoup& soup, const Vec3& at,
                  const Quat& q = Quat::Identity()) {
  return {name, test::body(soup), {q, at}};
}

// Reference: every pair of boxes, one by one.
TEST(BoxPairs, are_all_boxes_that_meet_or_touch) {
  std::mt19937_64 random(1);
  std::vector<AxisBox> boxes;
  for (int i = 0; i < 300; ++i) {
    const Vec3 low = test::random_in_ball(random, 1);
    boxes.push_back({low, low + 0.3 * test::random_in_ball(random, 1).cwiseAbs()});
  }
  boxes.push_back({boxes[0].high, boxes[0].high + Vec3::Ones()});  // touches at a corner
  std::vector<std::array<std::size_t, 2>> expected;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if ((boxes[i].low.array() <= boxes[j].high.array()).all() &&
          (boxes[j].low.array() <= boxes[i].high.array()).all())
        expected.push_back({i, j});
  EXPECT_EQ(pairs_that_meet(boxes), expected);
  EXPECT_GT(expected.size(), 100u);
}

// Reference: plates on a plate, in it by a known length, touching it, and above it.
TEST(Clash, plates_are_as_deep_as_they_were_put) {
  std::vector<AssemblyPart> parts{part("ground", test::box({1, 1, 0.1}), Vec3::Zero())};
  const std::vector<double> depths{2e-3, 1e-5, 1e-6};
  for (std::size_t i = 0; i < depths.size(); ++i)
    parts.push_back(part("in", test::box({0.1, 0.1, 0.04}),
                         Vec3(-0.3 + 0.2 * static_cast<double>(i), 0, 0.07 - depths[i])));
  parts.push_back(part("on", test::box({0.1, 0.1, 0.04}), Vec3(0.35, 0, 0.07)));
  parts.push_back(part("above", test::box({0.1, 0.1, 0.04}), Vec3(0.35, 0.3, 0.073)));
  parts.push_back(part("away", test::box({0.1, 0.1, 0.04}), Vec3(5, 0, 0)));
  const auto found = clashes(parts, {.within = 0.01, .threads = 2});
  ASSERT_EQ(found.size(), 5u);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    EXPECT_EQ(found[i].kind, Clash::Kind::overlapping);
    EXPECT_EQ(found[i].parts[1], i + 1);
    ASSERT_TRUE(found[i].depth);
    EXPECT_NEAR(*found[i].depth, depths[i], 1e-6 * depths[i] + 1e-15) << i;
    EXPECT_EQ(found[i].moved, i + 1) << "the smaller one moves";
    EXPECT_NEAR(found[i].separated->p.z(), 0.07, 1e-4 * depths[i]);
    EXPECT_NEAR(found[i].place->z(), 0.05, 1e-9);
  }
  EXPECT_EQ(found[3].kind, Clash::Kind::touching);
  EXPECT_EQ(found[3].parts[1], 4u);
  EXPECT_EQ(found[4].kind, Clash::Kind::clear);
  EXPECT_NEAR(*found[4].clearance, 0.003, 1e-15);
  EXPECT_FALSE(found[4].depth);
  // With an allowance, what is no deeper touches.
  const auto allowed = clashes(parts, {.allowance = 1.5e-5, .within = 0.01});
  EXPECT_EQ(allowed[0].kind, Clash::Kind::overlapping);
  EXPECT_EQ(allowed[1].kind, Clash::Kind::touching);
  EXPECT_EQ(allowed[2].kind, Clash::Kind::touching);
  EXPECT_EQ(clashes(parts, {}).size(), 4u) << "what is clear is left out";
}

// Reference: the circle at which one ring lies on the other; the line along which a round part lies
// on a plate.
TEST(Clash, parts_that_touch_say_where) {
  for (const auto& [major, minor] : {std::pair{1.0, 0.2}, {0.05, 0.02}, {3.0, 0.1}})
    for (const int steps : {8, 24}) {
      const PolygonSoup ring = test::torus(major, minor, 2 * steps, steps);
      const auto found = clashes(
          {part("below", ring, Vec3::Zero()), part("above", ring, Vec3(0, 0, 2 * minor))}, {});
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].kind, Clash::Kind::touching);
      EXPECT_FALSE(found[0].fit);
      ASSERT_TRUE(found[0].place) << major;
      EXPECT_NEAR(found[0].place->z(), minor, 1e-9 * major);
      EXPECT_NEAR(found[0].place->head<2>().norm(), major, minor) << "on the rings";
    }
}

// Reference: the exact test of every pair.
TEST(Clash, no_pair_that_overlaps_is_missed_wherever_the_parts_are) {
  std::mt19937_64 random(2);
  std::vector<AssemblyPart> parts;
  for (int i = 0; i < 40; ++i)
    parts.push_back(part("ring", test::torus(0.1, 0.04, 12, 8),
                         test::random_in_ball(random, 0.4) + Vec3(300, -200, 100),
                         test::random_rotation(random)));
  const auto found = clashes(parts, {.within = 0.02, .threads = 2});
  std::size_t overlaps = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      const Transform X(inverse(parts[j].X_WM) * parts[i].X_WM);
      const bool meets = overlap(*parts[i].body, *parts[j].body, X, Doubt::exact);
      const auto listed = std::ranges::find_if(found, [&](const Clash& c) {
        return c.parts == std::array{i, j};
      });
      if (meets) {
        ASSERT_NE(listed, found.end());
        EXPECT_EQ(listed->kind, Clash::Kind::overlapping);
        EXPECT_GT(*listed->depth, 0);
        EXPECT_LE(listed->lower_bound.value_or(0), *listed->depth);
      } else if (listed != found.end()) {
        EXPECT_EQ(listed->kind, Clash::Kind::clear);
      }
      overlaps += meets;
    }
  EXPECT_GT(overlaps, 20u);
  EXPECT_TRUE(std::ranges::is_sorted(found, {}, &Clash::kind));
  const auto one = clashes(parts, {.within = 0.02, .threads = 1});
  ASSERT_EQ(one.size(), found.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].depth, found[i].depth);
}

TEST(Clash, is_cancelled) {
  std::vector<AssemblyPart> parts{part("a", test::box({1, 1, 1}), Vec3::Zero()),
                                  part("b", test::box({1, 1, 1}), Vec3(0.5, 0, 0))};
  EXPECT_THROW(clashes(parts, {}, [](double) { return false; }), Cancelled);
}

/// The numbers of "M x y L x y" in a path of that colour.
std::vector<double> numbers_of_path(const std::string& svg, std::size_t colour) {
  const std::size_t end = svg.find("\" fill=\"none\" stroke=\"" + svg::series_color(colour));
  const std::size_t begin = svg.rfind("d=\"", end) + 3;
  std::string path = svg.substr(begin, end - begin);
  std::ranges::replace_if(
      path, [](char c) { return c == 'M' || c == 'L'; }, ' ');
  std::istringstream in(path);
  std::vector<double> out;
  for (double x = 0; in >> x;) out.push_back(x);
  return out;
}

// Reference: by hand. A small cube of 0.1 m stands 10 mm deep in a large one. In the picture up is
// the way out, the place is in the middle, and the small one's outline is a square.
TEST(ClashPicture, is_a_section_that_holds_the_way_out) {
  const std::vector<AssemblyPart> parts{
      part("large", test::box({1, 1, 0.5}), Vec3::Zero()),
      part("small", test::box({0.1, 0.1, 0.1}), Vec3(0.02, 0.01, 0.29))};
  const auto found = clashes(parts, {.threads = 1});
  ASSERT_EQ(found.size(), 1u);
  const std::string svg = clash_picture(parts[0], parts[1], found[0]);
  EXPECT_NE(svg.find(">large</text>"), std::string::npos);
  EXPECT_NE(svg.find("overlapping, 10 mm deep"), std::string::npos);
  const std::vector<double> small = numbers_of_path(svg, 1), large = numbers_of_path(svg, 0);
  ASSERT_FALSE(small.empty());
  ASSERT_FALSE(large.empty());
  double low = 1e9, high = -1e9;
  for (std::size_t i = 1; i < small.size(); i += 2)
    low = std::min(low, small[i]), high = std::max(high, small[i]);
  const double scale = 420 / (2 * 1.3 * 0.05 * std::sqrt(3.0));  // pixels a metre
  EXPECT_NEAR(high - low, 0.1 * scale, 0.05);
  const double ground = *std::ranges::min_element(
      large, {}, [&large](const double& x) { return (&x - large.data()) % 2 == 0 ? 1e9 : x; });
  EXPECT_NEAR(high - ground, 0.01 * scale, 0.05) << "10 mm deep";
}

TEST(ClashPicture, of_no_place_says_so) {
  const auto a = part("a & b", test::box({1, 1, 1}), Vec3::Zero());
  Clash failed;
  failed.reason = "a reason";
  const std::string svg = clash_picture(a, a, failed);
  EXPECT_NE(svg.find("a &amp; b"), std::string::npos);
  EXPECT_NE(svg.find("failed: a reason"), std::string::npos);
  EXPECT_NE(svg.find("no place is known"), std::string::npos);
}

}  // namespace
}  // namespace sonde
