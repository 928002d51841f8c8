// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/parts.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/geometry/topology.hpp"
#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::vector<PartFacts> judged(const PolygonSoup& mesh) {
  const Soup soup = test::welded(mesh);
  const Seams seams = find_seams(soup, edge_uses(soup));
  const Orientation orientation = find_orientation(soup, seams.uses);
  const std::vector<Cap> caps = find_caps(soup, seams.uses, orientation);
  return judge_parts(seal(soup, seams, orientation, caps), caps, orientation.conflicts);
}

/// A ball of radius 1 without what lies above that height.
PolygonSoup bowl(double height) {
  return test::without(test::icosphere(1, 5), [=](const Vec3& x) { return x.z() > height; });
}

// Reference: by Cauchy's formula, of a convex body the ends of lines are spread as its area is: the
// cap's share is its area over all. (Its rim is jagged, the mesh being what it is.)
TEST(Parts, the_mouth_of_a_bowl_is_its_share_of_the_surface) {
  for (const double height : {0.97, 0.8, 0.5, 0.0}) {
    const PartFacts part = judged(bowl(height)).at(0);
    const double cap = std::numbers::pi * (1 - height * height);
    const double rest = 2 * std::numbers::pi * (1 + height);
    EXPECT_NEAR(part.mouth, cap / (cap + rest), 0.012) << height;
    EXPECT_NEAR(part.open, part.mouth, 1e-12);
    EXPECT_EQ(part.looks_solid(), height > 0.94);
  }
}

// Reference: what is left of the mouth is what the lid leaves open.
TEST(Parts, a_lid_covers_a_mouth) {
  const PolygonSoup lid = test::placed(test::box({1.9, 1.9, 0.1}), {0, 0, 0.6});
  const auto facts = judged(test::joined(bowl(0.5), lid));
  EXPECT_GT(judged(bowl(0.5)).at(0).mouth, 0.18);
  EXPECT_LT(facts.at(0).mouth, 0.02);
  EXPECT_TRUE(facts.at(0).looks_solid());
}

TEST(Parts, an_open_sheet_is_half_mouth) {
  const PolygonSoup sheet =
      test::without(test::box({2, 2, 0.2}), [](const Vec3& x) { return x.z() < 0.09; });
  EXPECT_TRUE(judged(sheet).at(0).flat);  // a plane and its cap hold nothing
  const PolygonSoup bent =
      test::moved(test::cut_beyond(test::cut_beyond(sheet, Vec3::UnitX(), -9), Vec3::UnitX(), -9),
                  [](const Vec3& x) { return Vec3(x.x(), x.y(), 0.1 * x.x() * x.x()); });
  const PartFacts part = judged(bent).at(0);
  EXPECT_FALSE(part.flat);
  EXPECT_NEAR(part.mouth, 0.5, 0.03);
  EXPECT_FALSE(part.looks_solid());
}

// Each part by itself: what is beside it, or covers it, does not decide.
TEST(Parts, each_is_judged_by_itself) {
  const auto facts = judged(test::joined(
      test::joined(bowl(0.97), test::moved(bowl(0.0), [](const Vec3& x) { return Vec3(1e-3 * x); }),
                   {5, 0, 0}),
      test::without(test::box({20, 20, 1}), [](const Vec3& x) { return x.z() > -0.49; }),
      {0, 0, -2}));
  ASSERT_EQ(facts.size(), 3u);
  EXPECT_TRUE(facts[0].looks_solid());
  EXPECT_NEAR(facts[1].mouth, 1.0 / 3, 0.02);
  EXPECT_FALSE(facts[1].looks_solid());
  EXPECT_TRUE(facts[2].flat);
}

// Many small holes are no mouth, but all of them together may be a net.
TEST(Parts, a_net_is_no_solid) {
  const auto net = [](double share) {
    std::size_t k = 0;
    return test::without(test::icosphere(1, 4), [=](const Vec3&) mutable {
      const bool out = std::fmod(double(++k) * 0.618034, 1) < share;
      return out;
    });
  };
  EXPECT_TRUE(judged(net(0.05)).at(0).looks_solid());
  bool any = false;
  for (const PartFacts& part : judged(net(0.6))) any = any || part.looks_solid();
  EXPECT_FALSE(any);
}

// A sheet and the lid that closes it bound nothing, however finely it is cut and wherever it lies.
TEST(Parts, a_sheet_and_its_lid_are_flat) {
  for (const int squares : {3, 4, 5, 8, 17})
    for (const double size : {1e-3, 1.0, 400.0})
      for (const bool turned : {false, true}) {
        PolygonSoup sheet;
        for (int i = 0; i <= squares; ++i)
          for (int j = 0; j <= squares; ++j) sheet.points.push_back({size * i, size * j, 0});
        const auto at = [&](int i, int j) {
          return static_cast<std::size_t>(i * (squares + 1) + j);
        };
        for (int i = 0; i < squares; ++i)
          for (int j = 0; j < squares; ++j)
            sheet.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        const Quat q = Quat(0.4, 0.3, -0.5, 0.7).normalized();
        if (turned) sheet = test::moved(sheet, [&](const Vec3& x) { return Vec3(q * x); });
        for (const PartFacts& part : judged(sheet)) EXPECT_TRUE(part.flat) << squares << size;
      }
}

TEST(Parts, lobes_that_cancel_are_not_flat) {
  const PolygonSoup bow = test::moved(test::triangulated(test::box({2, 2, 2})), [](const Vec3& x) {
    return x.z() > 0 ? Vec3(-x.x(), x.y(), x.z()) : x;
  });
  const PartFacts part = judged(bow).at(0);
  EXPECT_NEAR(part.volume, 0, 1e-12);
  EXPECT_FALSE(part.flat);
  EXPECT_TRUE(part.looks_solid());
}

}  // namespace
}  // namespace sonde
