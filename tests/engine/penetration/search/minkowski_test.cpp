// SPDX-License-Identifier: GPL-3.0-or-later
// Translational depth against the exact Minkowski sum B ⊕ (−A) of two solids, convex or not: A
// moved by t overlaps B where t lies inside it, so PD_t is the distance from the origin to its
// boundary (a hollow in it is a place for A too). Exact arithmetic; trusted wherever it can be
// afforded, which is up to about 2000 pairs of faces. In a source and a program of its own: the
// headers take a minute and 2 GB to compile.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/minkowski_sum_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "engine/penetration/search/static_search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Faces = std::vector<std::vector<std::size_t>>;

Nef exact_solid(const std::vector<Vec3>& corners, const Faces& faces) {
  std::vector<Point> points;
  for (const Vec3& p : corners) points.emplace_back(p.x(), p.y(), p.z());
  Polyhedron mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, mesh);
  return Nef(mesh);
}

Faces triangles(const Body& body) {
  Faces out;
  for (const Triangle& t : body.soup.triangles) out.push_back({t[0], t[1], t[2]});
  return out;
}

/// −A at X_FM. A point reflection turns a solid inside out: its faces are reversed.
Nef reflected(const Body& body, const Pose& X_FM) {
  std::vector<Vec3> corners;
  for (const Vec3& v : body.soup.vertices) corners.push_back(-(X_FM * v));
  Faces faces = triangles(body);
  for (auto& f : faces) std::reverse(f.begin(), f.end());
  return exact_solid(corners, faces);
}

double boundary_distance(const Nef& solid) {
  std::vector<Point> points;
  Faces faces;
  CGAL::convert_nef_polyhedron_to_polygon_soup(solid, points, faces, true);
  const Point origin(0, 0, 0);
  double best = std::numeric_limits<double>::infinity();
  for (const auto& f : faces) {
    const Kernel::Triangle_3 t(points[f[0]], points[f[1]], points[f[2]]);
    if (t.is_degenerate()) continue;
    best = std::min(best, std::sqrt(CGAL::to_double(CGAL::squared_distance(origin, t))));
  }
  return best;
}

double exact_translational_depth(const Body& probe, const Pose& X_FM, const Body& fixed) {
  Nef a = reflected(probe, X_FM), b = exact_solid(fixed.soup.vertices, triangles(fixed));
  return boundary_distance(CGAL::minkowski_sum_3(b, a));
}

/// A polygon in the plane, counter-clockwise, given a height.
PolygonSoup prism(const std::vector<std::array<double, 2>>& outline, double height) {
  PolygonSoup out;
  const std::size_t n = outline.size();
  for (const double z : {-height / 2, height / 2})
    for (const auto& p : outline) out.points.push_back(Vec3(p[0], p[1], z));
  std::vector<std::size_t> bottom, top;
  for (std::size_t i = 0; i < n; ++i) {
    bottom.insert(bottom.begin(), i);
    top.push_back(n + i);
    const std::size_t j = (i + 1) % n;
    out.polygons.push_back({i, j, n + j, n + i});
  }
  out.polygons.push_back(bottom);
  out.polygons.push_back(top);
  return out;
}

PolygonSoup angle_bar() {
  return prism({{-0.1, -0.1}, {0.1, -0.1}, {0.1, -0.04}, {-0.04, -0.04}, {-0.04, 0.1}, {-0.1, 0.1}},
               0.12);
}
PolygonSoup channel() {
  return prism({{-0.12, -0.1},
                {0.12, -0.1},
                {0.12, 0.1},
                {0.06, 0.1},
                {0.06, -0.05},
                {-0.06, -0.05},
                {-0.06, 0.1},
                {-0.12, 0.1}},
               0.15);
}

struct Case {
  const char* name;
  PolygonSoup probe, fixed;
};

TEST(Minkowski, translational_depth_of_solids_that_need_not_be_convex) {
  std::mt19937_64 random(1);
  const std::vector<Case> pairs = {
      {"box in angle bar", test::box({0.04, 0.06, 0.1}), angle_bar()},
      {"box in channel", test::box({0.05, 0.05, 0.2}), channel()},
      {"angle bar in box", angle_bar(), test::box({0.1, 0.1, 0.1})},
      {"tetrahedron in channel", test::tetrahedron(0.08), channel()},
      {"tetrahedron in ring", test::tetrahedron(0.05), test::torus(0.1, 0.04, 6, 4)},
  };
  StaticOptions options;
  options.method = Method::pdt;
  int cases = 0;
  for (const Case& pair : pairs) {
    const auto probe = test::body(pair.probe), fixed = test::body(pair.fixed);
    ASSERT_TRUE(probe->solid && fixed->solid);
    ASSERT_LE(probe->soup.triangles.size() * fixed->soup.triangles.size(), 2000u);
    const Pair bodies(probe, fixed);
    for (int i = 0; i < 4; ++i) {
      const Pose X{test::random_rotation(random), test::random_in_ball(random, 0.12)};
      const Separation got = separate_static(bodies, X, options);
      if (got.status == Status::separated) continue;
      const std::string what = std::string(pair.name) + " " + std::to_string(i);
      ASSERT_EQ(got.status, Status::penetrating) << what << ": " << got.reason;
      const double reference = exact_translational_depth(*probe, X, *fixed);
      const double radius = probe->mass.radius;
      const double clearance = std::max(1e-9 * radius, 1e-4 * std::min(radius, reference));
      EXPECT_LE(got.depth, reference * 1.001 + clearance) << what;
      EXPECT_GE(got.depth, reference * (1 - 1e-9) - 1e-12 * radius) << what;
      ++cases;
    }
  }
  EXPECT_GE(cases, 12);
}

// The reference itself where it is known by hand.
TEST(Minkowski, two_boxes_by_hand) {
  const auto probe = test::body(test::box({0.1, 0.2, 0.3})),
             fixed = test::body(test::box({1, 1, 1}));
  const Pose X{Quat::Identity(), Vec3(0.5, 0.1, -0.2)};
  EXPECT_NEAR(exact_translational_depth(*probe, X, *fixed), 0.05, 1e-15);
}

}  // namespace
}  // namespace sonde
