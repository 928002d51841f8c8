// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/offset_faces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "engine/geometry/mass_integrals.hpp"
#include "engine/offset/corner_planes.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/inside.hpp"
#include "engine/proximity/queries/point_distance.hpp"
#include "engine/proximity/queries/self_intersections.hpp"
#include "tests/engine/offset/prisms.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/real_meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::Outline;

constexpr double um = 1e-6, mm = 1e-3;

Eigen::AlignedBox3d bounds(const Body& body) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : body.soup.vertices) box.extend(x);
  return box;
}
double volume(const Body& body) { return mass_by_volume(body.soup).measure; }

std::string refusal(const Body& body, double by) {
  try {
    offset_faces(body, by);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(OffsetFaces, a_peg_as_large_as_its_hole_fits_with_the_allowance_as_clearance) {
  for (const Outline& outline : test::pegs())
    for (const double allowance : {10 * um, 1 * um, 120 * um}) {
      const auto block = test::body(test::block_with_hole(outline, 20 * mm));
      const auto nominal = test::body(test::prism(outline, 30 * mm));
      ASSERT_TRUE(block->solid && nominal->solid);
      EXPECT_EQ(separate_static({nominal, block}, {}).status, Status::penetrating)
          << "touching is no separation";
      const auto peg = offset_faces(*nominal, -allowance);
      const Distance gap = distance(*peg, *block, Transform());
      EXPECT_FALSE(gap.overlapping);
      EXPECT_NEAR(gap.distance, allowance, 1e-14);
      EXPECT_EQ(separate_static({peg, block}, {}).status, Status::separated);
      EXPECT_EQ(peg->offset.held_back, 0U);
      EXPECT_EQ(peg->soup.triangles.size(), nominal->soup.triangles.size());
    }
}

TEST(OffsetFaces, a_gap_shrinks_by_the_safety) {
  for (const Outline& outline : test::pegs())
    for (const double gap : {100 * um, 35 * um}) {
      const auto block = test::body(test::block_with_hole(outline, 20 * mm));
      const auto nominal = test::body(test::prism(test::moved(outline, -gap), 30 * mm));
      EXPECT_NEAR(distance(*nominal, *block, Transform()).distance, gap, 1e-14);
      const auto peg = offset_faces(*nominal, 30 * um);
      EXPECT_NEAR(distance(*peg, *block, Transform()).distance, gap - 30 * um, 1e-14);
    }
}

TEST(OffsetFaces, a_box_is_the_box_of_other_sides) {
  for (const Vec3& size : {Vec3(1, 2, 3), Vec3(0.02, 0.02, 0.02), Vec3(5, 0.001, 0.3)})
    for (const double by : {-1e-4, -1e-7, 1e-4, 0.3}) {
      const auto body = offset_faces(*test::body(test::box(size)), by);
      const Vec3 half = size / 2 + Vec3::Constant(by);
      for (const Vec3& x : body->soup.vertices)
        EXPECT_LT((x.cwiseAbs() - half).cwiseAbs().maxCoeff(), 4e-16 * half.maxCoeff()) << by;
      EXPECT_EQ(body->offset.by, by);
      EXPECT_NEAR(body->offset.furthest, std::sqrt(3) * std::abs(by), 1e-15 * half.maxCoeff());
    }
}

TEST(OffsetFaces, concave_outlines_are_those_of_moved_lines) {
  const std::vector<Outline> outlines{
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},                  // L
      {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},  // U
      {{0, 0}, {5, 0}, {4, 1}, {2, 1.5}, {5, 4}, {0.5, 4}, {1.5, 2}},    // sharp
      {{-1, -0.2}, {1, -0.2}, {1, 0.2}, {0.2, 0.2}, {0.2, 2}, {-0.2, 2}, {-0.2, 0.2}, {-1, 0.2}}};
  for (const Outline& outline : outlines)
    for (const double by : {-0.01, -0.15, 0.01, 0.15}) {
      const auto body = offset_faces(*test::body(test::prism(outline, 2)), by);
      const double expected = test::area(test::moved(outline, by)) * (2 + 2 * by);
      EXPECT_NEAR(volume(*body), expected, 1e-12 * expected) << by;
      EXPECT_TRUE(analyse_topology(body->soup).closed);
      EXPECT_EQ(self_intersections(body->soup).pairs, 0U);
    }
}

PolygonSoup cone(int sides, double radius, double height) {
  PolygonSoup out = test::prism(test::regular(sides, radius), height);
  out.points.resize(std::size_t(sides));
  for (Vec3& x : out.points) x.z() = 0;
  out.points.emplace_back(0, 0, height);
  const Polygon base = out.polygons[std::size_t(sides)];
  out.polygons = {base};
  for (std::size_t i = 0; i < std::size_t(sides); ++i)
    out.polygons.push_back({i, (i + 1) % std::size_t(sides), std::size_t(sides)});
  return out;
}

TEST(OffsetFaces, the_tip_of_a_cone_moves_along_its_axis) {
  for (const int sides : {3, 4, 7, 64, 500})
    for (const double height : {0.5, 3.0})
      for (const double by : {-0.01, 0.01}) {
        const auto body = offset_faces(*test::body(cone(sides, 1, height)), by);
        const double apothem = std::cos(std::numbers::pi / sides);
        const double tip = height + by / std::sin(std::atan(apothem / height));
        EXPECT_NEAR(bounds(*body).max().z(), tip, 1e-12) << sides;
        EXPECT_NEAR(bounds(*body).min().z(), -by, 1e-12) << sides;
      }
}

/// For a convex body: every point has to be below each plane by the allowance at least. The
/// reference are the planes of the nominal faces.
TEST(OffsetFaces, a_ball_is_deeper_than_the_allowance_below_each_of_its_faces) {
  for (const auto& [rings, segments] : {std::pair(8, 12), std::pair(30, 40), std::pair(60, 17)})
    for (const double by : {-0.001, -0.1, 0.05}) {
      const auto nominal = test::body(test::sphere(1, rings, segments));
      const auto body = offset_faces(*nominal, by);
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const Triangle& t : nominal->soup.triangles) {
        const auto& x = nominal->soup.vertices;
        const Vec3 n = (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).normalized();
        double highest = -std::numeric_limits<double>::infinity();
        for (const Vec3& y : body->soup.vertices) highest = std::max(highest, n.dot(y - x[t[0]]));
        if (by < 0) least = std::min(least, -highest);
        if (by > 0) least = std::min(least, highest);
        most = std::max(most, std::abs(highest));
      }
      EXPECT_GE(least, std::abs(by) * (1 - 1e-9)) << by;
      EXPECT_LE(most, std::abs(by) * 1.2) << by;
    }
}

/// The reference is the nominal body: the distance of points of the smaller one from its surface.
void expect_deeper(const Body& nominal, double by, const std::string& what) {
  ASSERT_EQ(self_intersections(nominal.soup).pairs, 0U) << what << " is no reference";
  const auto body = offset_faces(nominal, -by);
  ASSERT_EQ(body->offset.held_back, 0U) << what;
  std::size_t too_near = 0, outside = 0;
  for (const Triangle& t : body->soup.triangles) {
    const auto& x = body->soup.vertices;
    for (const Vec3& weights : {Vec3(1, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.2, 0.3, 0.5)}) {
      const Vec3 point = weights[0] * x[t[0]] + weights[1] * x[t[1]] + weights[2] * x[t[2]];
      too_near += point_distance(nominal, point) < by * (1 - 1e-4);
      outside += !winds_around(nominal, point);
    }
  }
  EXPECT_EQ(too_near, 0U) << what << ", of " << 3 * body->soup.triangles.size();
  EXPECT_EQ(outside, 0U) << what;
  EXPECT_EQ(self_intersections(body->soup).pairs, 0U) << what;
}

TEST(OffsetFaces, no_point_of_the_smaller_body_is_nearer_to_the_surface_than_the_allowance) {
  for (const double by : {0.001, 0.02}) {
    expect_deeper(*test::body(test::torus(1, 0.3, 40, 20)), by, "torus");
    expect_deeper(*test::body(test::torus_knot(2, 3, 1, 0.4, 0.1, 200, 12)), by, "knot");
    expect_deeper(*test::body(test::sphere(0.7, 20, 31)), by, "ball");
    expect_deeper(*test::body(test::tetrahedron(1)), by, "tetrahedron");
  }
  EXPECT_GT(self_intersections(test::real_body("camel.off")->soup).pairs, 0U);
  for (const char* name : {"elephant.off", "homer.off", "fandisk.off", "anchor.off"}) {
    const auto body = test::real_body(name);
    expect_deeper(*body, 1e-4 * body->mass.radius, name);
  }
}

TEST(OffsetFaces, rounded_edges_finer_than_the_allowance_become_sharp_ones) {
  for (const auto& [radius, chords] :
       {std::pair(0.05 * mm, 4), std::pair(0.2 * mm, 9), std::pair(0.3 * mm, 16)})
    for (const double allowance : {0.31 * mm, 1 * mm}) {
      const auto nominal =
          test::body(test::prism(test::rounded(20 * mm, 12 * mm, radius, chords), 15 * mm));
      const auto body = offset_faces(*nominal, -allowance);
      const double a = 20 * mm - 2 * allowance, b = 12 * mm - 2 * allowance;
      EXPECT_EQ(body->soup.vertices.size(), 8U) << radius;
      EXPECT_NEAR(volume(*body), a * b * (15 * mm - 2 * allowance), 1e-12 * a * b);
      EXPECT_LE(bounds(*body).max().x(), a / 2 + 1e-15);
      EXPECT_EQ(self_intersections(body->soup).pairs, 0U);
      EXPECT_EQ(body->offset.held_back, 0U);
    }
}

/// A blade whose sides are cut into strips near its edge: all of them go with it.
TEST(OffsetFaces, the_edge_of_a_blade_goes_back_with_whatever_is_cut_there) {
  for (const double half_angle : {0.1, 0.3, 0.7})
    for (const int strips : {1, 3, 20}) {
      Outline outline{{1, -std::tan(half_angle)}, {1, std::tan(half_angle)}};
      for (int i = strips; i-- > 1;)
        outline.emplace_back(0.1 * i / strips, std::tan(half_angle) * 0.1 * i / strips);
      outline.emplace_back(0, 0);
      for (int i = 1; i < strips; ++i)
        outline.emplace_back(0.1 * i / strips, -std::tan(half_angle) * 0.1 * i / strips);
      const double allowance = 0.02;
      const auto body = offset_faces(*test::body(test::prism(outline, 1)), -allowance);
      const double back = allowance / std::sin(half_angle), length = 1 - allowance - back;
      EXPECT_NEAR(bounds(*body).min().x(), back, 1e-9) << half_angle << " " << strips;
      const double expected = length * length * std::tan(half_angle) * (1 - 2 * allowance);
      EXPECT_NEAR(volume(*body), expected, 1e-9) << half_angle << " " << strips;
    }
}

TEST(OffsetFaces, thinner_than_twice_the_allowance_is_refused_with_the_thickness) {
  const auto neck = [](double thick) -> Outline {
    return {{-1, -1}, {0, -thick / 2}, {1, -1}, {1, 1}, {0, thick / 2}, {-1, 1}};
  };
  const auto hollow = [](double wall) {
    return test::together(test::box({1, 1, 1}),
                          test::inside_out(test::box(Vec3::Constant(1 - 2 * wall))));
  };
  for (const double thick : {0.01, 0.04, 0.1}) {
    const std::vector<PolygonSoup> thin{
        test::box({1, 2, thick}), test::prism(test::regular(24, 1), thick),
        test::prism(neck(thick), 2), hollow(thick),
        test::together(test::sphere(1, 20, 30),
                       test::inside_out(test::sphere(1 - thick / std::cos(0.15), 20, 30)))};
    for (std::size_t i = 0; i < thin.size(); ++i) {
      const auto body = test::body(thin[i]);
      ASSERT_TRUE(body->solid) << i;
      const std::string said = refusal(*body, -0.55 * thick);
      EXPECT_THAT(said, testing::HasSubstr("turns parts of it inside out")) << i << " " << thick;
      const char* const found = thick == 0.01 ? "10 mm thick" : "0 mm thick";
      if (i < 4) {
        EXPECT_THAT(said, testing::HasSubstr(found)) << i;
      }
      EXPECT_EQ(refusal(*body, -0.3 * thick), "accepted") << i << " " << thick;
    }
  }
  // Two opposite faces of a regular solid are the thinnest place of it, 2√((5 + 2√5) / 15) =
  // 1.589 radii of an icosahedron.
  for (const auto& [radius, thick] :
       {std::pair{0.01, "15.8931 mm thick"}, {1.0, "1.58931 m thick"}, {30.0, "47.6793 m thick"}})
    EXPECT_THAT(refusal(*test::body(test::icosphere(radius, 0)), -0.8 * radius),
                testing::HasSubstr(thick));
  const auto ball = test::body(test::sphere(0.01, 12, 20));
  EXPECT_THAT(refusal(*ball, -0.02), testing::HasSubstr("inside out"));
  EXPECT_THAT(refusal(*ball, -1e9), testing::HasSubstr("inside out"));
}

/// Two boxes that share an edge, a corner, a wall; that lie in each other.
TEST(OffsetFaces, parts_that_touch_are_each_taken_smaller) {
  const PolygonSoup box = test::box({1, 1, 1});
  const double by = -0.01, cube = 0.98 * 0.98 * 0.98;
  for (const Vec3& at : {Vec3(1, 1, 0), Vec3(1, 0, -1), Vec3(1, 1, 1), Vec3(-1, 1, 1)}) {
    const auto body = offset_faces(*test::body(test::together(box, box, at)), by);
    EXPECT_NEAR(volume(*body), 2 * cube, 1e-14);
    EXPECT_TRUE(analyse_topology(body->soup).closed);
    EXPECT_EQ(body->component_triangle.size(), 2U) << "they are apart now";
  }
  const auto stacked = offset_faces(*test::body(test::together(box, box, {0, 0, 1})), by);
  EXPECT_NEAR(volume(*stacked), 0.98 * 0.98 * 1.98, 1e-14) << "the wall between is no face";
  const auto crossing = offset_faces(*test::body(test::together(box, box, {0.3, 0.2, 0.4})), by);
  EXPECT_LT((bounds(*crossing).max() - Vec3(0.79, 0.69, 0.89)).norm(), 1e-15);
  EXPECT_LT((bounds(*crossing).min() + Vec3(0.49, 0.49, 0.49)).norm(), 1e-15);
}

/// An edge cut on one side alone, and closed by a triangle without area, as exporters write it.
TEST(OffsetFaces, an_edge_that_is_cut_on_one_side_stays_one) {
  for (const double at : {0.0, 0.3, -0.45})
    for (const double by : {-0.02, 0.02}) {
      PolygonSoup box = test::box({1, 1, 1});
      box.points.emplace_back(at, -0.5, -0.5);  // on the edge 0-1
      box.polygons[0] = {0, 2, 3, 1};           // below: not cut
      box.polygons[2] = {0, 8, 5, 4};           // in front: cut
      box.polygons.push_back({8, 1, 5});
      box.polygons.push_back({0, 1, 8});  // no area
      const auto nominal = test::body(box);
      ASSERT_TRUE(nominal->solid && nominal->degenerate == 1);
      const auto body = offset_faces(*nominal, by);
      EXPECT_NEAR(volume(*body), std::pow(1 + 2 * by, 3), 1e-13);
      for (const Vec3& x : body->soup.vertices)
        if (std::abs(x.x()) < 0.47) {
          EXPECT_NEAR(x.y(), -0.5 - by, 1e-15);
        }
    }
}

TEST(OffsetFaces, tips_of_blades_are_held_back_outwards) {
  for (const double half_angle : {0.01, 0.05, 0.09, 0.2}) {
    const double wide = std::tan(half_angle), by = 0.001;
    const auto nominal = test::body(test::prism({{0, 0}, {1, -wide}, {1, wide}}, 1));
    const auto body = offset_faces(*nominal, by);
    const double free = by / std::sin(half_angle), least = bounds(*body).min().x();
    if (std::hypot(free, by) < most_outward_way * by) {
      EXPECT_NEAR(least, -free, 1e-12);
      EXPECT_EQ(body->offset.held_back, 0U);
    } else {
      EXPECT_LE(body->offset.furthest, most_outward_way * by * (1 + 1e-12));
      EXPECT_EQ(body->offset.held_back, 2U);
      EXPECT_LT(body->offset.least, by);
      EXPECT_THAT(offset_words(body->offset), testing::HasSubstr("at 2 corners"));
    }
  }
}

TEST(OffsetFaces, gaps_narrower_than_twice_the_safety_are_filled) {
  for (const double gap : {0.01, 0.05, 0.15}) {
    const double g = gap / 2;
    const auto nominal = test::body(
        test::prism({{-1, -1}, {1, -1}, {1, 1}, {g, 1}, {g, 0}, {-g, 0}, {-g, 1}, {-1, 1}}, 1));
    const auto body = offset_faces(*nominal, 0.1);
    const auto probe = test::body(test::box({0.001, 0.001, 0.001}));
    const Pose in_gap{Quat::Identity(), Vec3(0, 0.5, 0)};
    EXPECT_TRUE(distance(*probe, *body, Transform(in_gap)).overlapping) << gap;
    EXPECT_FALSE(distance(*probe, *nominal, Transform(in_gap)).overlapping) << gap;
    EXPECT_GT(body->offset.filled, 0U);
    EXPECT_THAT(offset_words(body->offset), testing::HasSubstr("filled"));
  }
}

TEST(OffsetFaces, the_mass_stays_that_of_the_mesh) {
  for (const PolygonSoup& soup : {test::box({1, 2, 3}), test::torus(1, 0.3, 40, 20),
                                  test::prism(test::dovetail(2, 1, 1), 3)}) {
    const auto nominal = test::body(soup), smaller = offset_faces(*nominal, -0.01);
    EXPECT_EQ(smaller->mass.com, nominal->mass.com);
    EXPECT_EQ(smaller->mass.inertia, nominal->mass.inertia);
    EXPECT_EQ(smaller->mass.measure, nominal->mass.measure);
    EXPECT_LT(smaller->mass.radius, nominal->mass.radius);
    const auto again = offset_faces(*nominal, -0.01);
    EXPECT_EQ(again->soup.vertices, smaller->soup.vertices) << "the same bits";
    EXPECT_EQ(offset_faces(*smaller, 0.01)->offset.by, 0) << "offsets add up";
  }
}

TEST(OffsetFaces, zero_is_the_body_itself) {
  const auto nominal = test::body(test::box({1, 1, 1})), same = offset_faces(*nominal, 0);
  EXPECT_EQ(same->soup.vertices, nominal->soup.vertices);
  EXPECT_EQ(offset_words(same->offset), "");
}

TEST(OffsetFaces, surfaces_and_lengths_without_sense_are_refused) {
  const auto box = test::body(test::box({1, 1, 1}));
  EXPECT_EQ(refusal(*box, std::numeric_limits<double>::quiet_NaN()),
            "test shape: a safety must be at most 1e+30 m");
  EXPECT_EQ(refusal(*box, -std::numeric_limits<double>::infinity()),
            "test shape: an allowance must be at most 1e+30 m");
  for (const double huge : {1e31, 1e160, 1e300})
    EXPECT_THAT(refusal(*box, huge), testing::HasSubstr("must be at most 1e+30 m"));
  EXPECT_THAT(refusal(*box, 1e30), testing::HasSubstr("beyond 1e30 m"));
  PolygonSoup open = test::box({1, 1, 1});
  open.polygons.pop_back();
  const auto asked = test::body(test::box({1, 1, 1}), Model::surface);
  for (const auto& surface : {test::body(open), asked}) {
    EXPECT_THAT(refusal(*surface, -0.01),
                testing::HasSubstr("an allowance needs a solid, and this is a surface"));
    EXPECT_THAT(refusal(*surface, 0.01), testing::HasSubstr("a safety needs a solid"));
  }
}

TEST(OffsetFaces, words_say_which_surface_it_is) {
  EXPECT_EQ(offset_words({.by = -1e-5}), "taken 10 µm smaller (allowance)");
  EXPECT_EQ(offset_words({.by = 2.5e-3}), "taken 2.5 mm larger (safety)");
  EXPECT_EQ(offset_words({.by = -1e-8}), "taken 10 nm smaller (allowance)");
}

}  // namespace
}  // namespace sonde
