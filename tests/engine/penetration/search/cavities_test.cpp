// SPDX-License-Identifier: GPL-3.0-or-later
// Ways out that lead into a cavity. Its room for the probe may be small beside the room outside, so
// that hardly any random start begins there.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include "engine/base/numbers.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

/// A box with a box-shaped cavity: half sizes outside and inside, m.
struct Hollow {
  Vec3 outer, inner;
};
PolygonSoup surfaces_of(const Hollow& hollow) {
  PolygonSoup out = test::box(2 * hollow.outer);
  const PolygonSoup cavity = test::box(2 * hollow.inner);
  const std::size_t first = out.points.size();
  out.points.insert(out.points.end(), cavity.points.begin(), cavity.points.end());
  for (auto polygon : cavity.polygons) {
    std::ranges::reverse(polygon);
    for (auto& corner : polygon) corner += static_cast<decltype(corner + 0)>(first);
    out.polygons.push_back(polygon);
  }
  return out;
}

/// m: how far a box with half sizes h, turned by R, reaches along a direction.
double reach(const Mat3& R, const Vec3& h, const Vec3& along) {
  return (R.transpose() * along).cwiseAbs().dot(h);
}

/// Closed form of PD_t of the box h, turned by R, with its centre at c. Outside, both are convex:
/// the least overlap along a face normal of either or a product of two edges (the faces of their
/// Minkowski difference). Inside, each coordinate moves by itself.
double pdt_of(const Hollow& hollow, const Vec3& h, const Mat3& R, const Vec3& c) {
  double out = infinity;
  const auto along = [&](const Vec3& axis) {
    if (axis.norm() < 1e-9) return;
    const Vec3 n = axis.normalized();
    out = std::min(out, reach(R, h, n) + hollow.outer.dot(n.cwiseAbs()) - std::abs(n.dot(c)));
  };
  for (int i = 0; i < 3; ++i) {
    along(Vec3::Unit(i)), along(R.col(i));
    for (int j = 0; j < 3; ++j) along(Vec3::Unit(i).cross(R.col(j)));
  }
  Vec3 way = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    const double room = hollow.inner[i] - reach(R, h, Vec3::Unit(i));
    if (room <= 0) return std::max(0.0, out);
    way[i] = std::max(0.0, std::abs(c[i]) - room);
  }
  return std::max(0.0, std::min(out, way.norm()));
}

// Reference: the closed form. Wanted: 97 of 100 within 1 %. Other boxes, blocks with cavities,
// cups, bottles and tubes chose how the starts are made (measurements.md, "Cavities").
TEST(Cavities, a_box_finds_its_way_into_a_hollow_one) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::array<Hollow, 3> all{{{{0.6, 0.8, 1.1}, {0.51, 0.71, 1.01}},
                                   {{0.5, 0.5, 0.5}, {0.38, 0.43, 0.35}},
                                   {{0.02, 0.06, 0.05}, {0.015, 0.055, 0.045}}}};
  const std::array<Vec3, 3> probes{{{0.28, 0.26, 0.3}, {0.2, 0.2, 0.2}, {0.008, 0.009, 0.0085}}};
  int searched = 0, right = 0, into = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Hollow& hollow = all[k];
    const Vec3& h = probes[k];
    const Pair pair(test::body(test::box(2 * h)), test::body(surfaces_of(hollow)));
    ASSERT_TRUE(pair.probe().solid && pair.fixed().solid);
    for (int i = 0; i < 30; ++i) {
      const Quat q = test::random_rotation(random);
      const Vec3 c =
          0.9 * hollow.outer.cwiseProduct(Vec3(unit(random), unit(random), unit(random)));
      StaticOptions options{.method = Method::pdt, .seed = static_cast<std::uint64_t>(i)};
      options.want_lower_bound = false;
      const Separation got = separate_static(pair, {q, c}, options);
      const double true_depth = pdt_of(hollow, h, q.toRotationMatrix(), c);
      if (got.status == Status::separated) {
        EXPECT_EQ(true_depth, 0) << k << ' ' << i;
        continue;
      }
      ++searched;
      EXPECT_GE(got.depth, true_depth * (1 - 1e-9)) << k << ' ' << i;
      right += got.depth <= 1.01 * true_depth;
      const Vec3 end = got.separated.p.cwiseAbs();
      into += (end.array() < hollow.inner.array()).all();
    }
  }
  std::printf("  %d of %d within 1 %%, %d into the cavity\n", right, searched, into);
  EXPECT_GE(into, searched / 4) << "else these poses say little";
  EXPECT_GE(right, searched * 97 / 100);
}

}  // namespace
}  // namespace sonde
