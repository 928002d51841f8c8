// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/region_mass.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/engine/geometry/soup_of.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// Two closed meshes as two parts.
struct Two {
  Two(const PolygonSoup& a, const PolygonSoup& b) : soup(test::soup_of(test::joined(a, b))) {
    part.assign(test::soup_of(a).triangles.size(), 0);
    part.resize(soup.triangles.size(), 1);
  }
  Region region() const { return find_region(soup, part); }
  Soup soup;
  std::vector<std::uint32_t> part;
};

TEST(RegionMass, parts_that_do_not_overlap_are_left_alone) {
  const PolygonSoup box = test::box({1, 1, 1});
  for (const Vec3& by : {Vec3(2, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}) {
    const Region region = Two(box, test::placed(box, by)).region();
    EXPECT_FALSE(region.overlaps);
    EXPECT_TRUE(region.soup.triangles.empty());
  }
  // A cavity, and a body in it.
  EXPECT_FALSE(Two(test::box({3, 3, 3}), test::turned_over(box)).region().overlaps);
  // All of it inside out.
  EXPECT_FALSE(Two(test::turned_over(box), test::placed(test::turned_over(box), {2, 0, 0}))
                   .region()
                   .overlaps);
}

// Reference: the volume of the outer one; exact, as no two cross.
TEST(RegionMass, nested_parts_count_once_exactly) {
  const PolygonSoup inner[] = {test::box({1, 1, 1}), test::icosphere(0.4, 3),
                               test::torus(0.9, 0.2, 30, 12)};
  for (const PolygonSoup& small : inner) {
    const Two two(test::box({3, 2.5, 2}), test::placed(small, {0.2, 0.1, 0.1}));
    const Region region = two.region();
    ASSERT_TRUE(region.overlaps);
    EXPECT_EQ(region.error, 0);
    EXPECT_EQ(region.hidden, (std::vector<bool>{false, true}));
    const MassProperties mass = mass_of(region);
    EXPECT_NEAR(mass.measure, 15, 1e-13);
    EXPECT_NEAR(mass.com.norm(), 0, 1e-13);
    EXPECT_NEAR(mass.inertia[2], (9 + 6.25) / 12, 1e-12);
  }
}

// Reference: closed forms of unions: two boxes; two balls; a cross of two bars.
TEST(RegionMass, parts_that_cross_count_once) {
  struct Case {
    PolygonSoup a, b;
    double volume;
    Vec3 com;
    double tolerance;
  };
  const double lens = std::numbers::pi * (4 * 1 + 1) * std::pow(2 - 1, 2) / 12;
  const Case cases[] = {{test::box({1, 1, 1}), test::placed(test::box({1, 1, 1}), {0.5, 0.5, 0.5}),
                         1.875, Vec3::Constant(0.25), 1e-4},
                        {test::box({2, 1, 1}),
                         test::placed(test::box({1, 0.3, 0.3}), {1, 0.1, 0}),
                         2.045,
                         {0.045 * 1.25 / 2.045, 0.045 * 0.1 / 2.045, 0},
                         1e-4},
                        {test::icosphere(1, 5),
                         test::placed(test::icosphere(1, 5), {1, 0, 0}),
                         8 * std::numbers::pi / 3 - lens,
                         {0.5, 0, 0},
                         2e-3},
                        {test::box({4, 1, 1}), test::box({1, 4, 1}), 7, Vec3::Zero(), 1e-4}};
  for (const Case& c : cases) {
    const Region region = Two(c.a, c.b).region();
    ASSERT_TRUE(region.overlaps);
    EXPECT_TRUE(region.hidden.empty());
    const MassProperties mass = mass_of(region);
    EXPECT_NEAR(mass.measure, c.volume, c.tolerance * c.volume);
    EXPECT_LT((mass.com - c.com).norm(), c.tolerance);
    EXPECT_GT(region.error, 0);
    EXPECT_LT(region.error, 1e-4);
  }
}

PolygonSoup turned_about_z(const PolygonSoup& soup, double angle) {
  return test::moved(soup, [angle](const Vec3& x) {
    return Vec3(std::cos(angle) * x.x() - std::sin(angle) * x.y(),
                std::sin(angle) * x.x() + std::cos(angle) * x.y(), x.z());
  });
}

// Reference: closed forms. What thin parts have in common is so little of all that none of the
// lines through all of it meets it, but half a percent of the volume.
TEST(RegionMass, thin_parts_that_cross_count_once) {
  struct Case {
    PolygonSoup a, b;
    double together, common;
  };
  std::vector<Case> cases;
  for (const double t : {0.01, 0.004, 0.001}) {
    const PolygonSoup rod = test::box({1, t, t});
    for (const double angle : {0.5 * std::numbers::pi, 0.7})
      cases.push_back({test::triangulated(rod), turned_about_z(rod, angle), 2 * t * t,
                       t * t * t / std::sin(angle)});
    // An end in the other, which its corners are inside of; a needle through a plate.
    cases.push_back(
        {test::box({2 * t, 1, 2 * t}), test::placed(rod, {0.5, 0.3, 0}), 5 * t * t, t * t * t});
    cases.push_back({test::box({1, 1, t}), test::placed(test::box({t, t, 1}), {0.2, 0.3, 0}),
                     t + t * t, t * t * t});
  }
  for (const Case& c : cases)
    for (const double turn : {0.0, 0.9}) {
      const Region region = Two(turned_about_z(c.a, turn), turned_about_z(c.b, turn)).region();
      const double volume = c.together - c.common;
      if (!region.overlaps) {
        EXPECT_LT(c.common, overlap_tuning.least * volume);
        continue;
      }
      EXPECT_NEAR(mass_of(region).measure, volume,
                  std::max(1e-3 * c.common, region.error * volume));
      EXPECT_GT(region.error, 0);
      EXPECT_LT(region.error, 2 * c.common / volume);
    }
}

// Reference: closed form: four bars that cross by twos at their ends, each of which stands out. The
// error that is said is at least the true one, however it is turned.
TEST(RegionMass, the_error_that_is_said_of_a_turned_frame_holds) {
  std::mt19937_64 random(3);
  for (const double t : {0.04, 0.02, 0.011})
    for (const double high : {1.0, 0.6})
      for (int i = 0; i < 12; ++i) {
        const PolygonSoup bars[] = {test::placed(test::box({1, t, t}), {0, high / 3, 0}),
                                    test::placed(test::box({1, t, t}), {0, -high / 3, 0.2 * t}),
                                    test::placed(test::box({t, high, t}), {0.4, 0, 0.1 * t}),
                                    test::placed(test::box({t, high, t}), {-0.4, 0, -0.3 * t})};
        const Quat q = test::random_rotation(random);
        PolygonSoup all;
        std::vector<std::uint32_t> part;
        for (std::uint32_t p = 0; p < 4; ++p) {
          const PolygonSoup bar = test::moved(bars[p], [q](const Vec3& x) { return Vec3(q * x); });
          all = p == 0 ? bar : test::joined(all, bar);
          part.resize(test::soup_of(all).triangles.size(), p);
        }
        const Region region = find_region(test::soup_of(all), part);
        const double volume =
            2 * t * t * (1 + high) - t * t * t * (0.9 + 0.7 + 0.9 + 0.5);  // at the four joints
        EXPECT_LE(std::abs(mass_of(region).measure - volume), region.error * volume)
            << t << " " << high << " off by " << mass_of(region).measure / volume - 1;
        EXPECT_LT(region.error, 0.02);
      }
}

// Lobes of winding +1 and -1: a box whose upper half is mirrored. Reference: half of it each,
// two wedges of 2 x 2 x 2 together 4 (the sum over the triangles is 0).
TEST(RegionMass, lobes_that_wind_the_other_way_count) {
  const PolygonSoup bow = test::moved(test::triangulated(test::box({2, 2, 2})), [](const Vec3& x) {
    return x.z() > 0 ? Vec3(-x.x(), x.y(), x.z()) : x;
  });
  const Soup soup = test::soup_of(bow);
  const Region region = find_region(soup, std::vector<std::uint32_t>(soup.triangles.size(), 0));
  ASSERT_TRUE(region.overlaps);
  EXPECT_NEAR(mass_of(region).measure, 4, 1e-4);
}

// A cavity in what is nested in another: it is filled by that one, and both are inside.
TEST(RegionMass, a_cavity_of_a_nested_part_is_filled) {
  const PolygonSoup outer = test::box({4, 4, 4}), nested = test::box({2, 2, 2}),
                    cavity = test::turned_over(test::box({1, 1, 1}));
  Two two(test::joined(outer, nested), cavity);
  std::fill(two.part.begin() + 12, two.part.begin() + 24, 1);
  std::fill(two.part.begin() + 24, two.part.end(), 2);
  const Region region = two.region();
  ASSERT_TRUE(region.overlaps);
  EXPECT_EQ(region.hidden, (std::vector<bool>{false, true, true}));
  EXPECT_NEAR(mass_of(region).measure, 64, 1e-12);
}

}  // namespace
}  // namespace sonde
