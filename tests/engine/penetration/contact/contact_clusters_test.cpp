// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/contact_clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/engine/penetration/separation_checks.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/pairs.hpp"

namespace sonde {
namespace {

constexpr double pi = std::numbers::pi;

Quat turn(double angle, const Vec3& axis) { return Quat(Eigen::AngleAxisd(angle, axis)); }

/// Boxes, closed each on its own, as one solid.
struct Block {
  Vec3 size;
  Vec3 middle;
};
std::shared_ptr<const Body> blocks(const std::vector<Block>& all) {
  PolygonSoup out;
  for (const Block& b : all) {
    const PolygonSoup one = test::scaled_and_moved(test::box(b.size), 1, b.middle);
    const std::size_t first = out.points.size();
    out.points.insert(out.points.end(), one.points.begin(), one.points.end());
    for (auto polygon : one.polygons) {
      for (auto& corner : polygon) corner += static_cast<decltype(+corner)>(first);
      out.polygons.push_back(polygon);
    }
  }
  return test::body(out);
}

std::shared_ptr<const Body> turned(PolygonSoup soup, const Quat& q) {
  for (Vec3& x : soup.points) x = q * x;
  return test::body(soup);
}

// Reference for all that follows: statics by hand. What a separation keeps free is 1e-4 of the
// depth.
constexpr double clearance = 2e-4;

TEST(ContactClusters, a_box_flat_on_a_plate_is_one_at_the_centre_of_pressure) {
  const auto box = test::body(test::box({0.1, 0.16, 0.06}));
  const auto plate = blocks({{{1, 1, 0.5}, {0, 0, -0.25}}});
  const double depth = 0.004;
  const Pose X{turn(0.4, Vec3::UnitZ()), Vec3(0.02, -0.01, 0.03 - depth)};
  CoherentSolver solver({box, plate});
  solver.reset({X.q, X.p + Vec3(0, 0, 0.01)});
  const Separation& s = solver.tick(X);
  EXPECT_GE(s.contacts.size, 2);  // corners across from each other carry a weight between them
  ASSERT_EQ(s.clusters.size, 1);
  const ContactCluster& c = s.clusters[0];
  EXPECT_EQ(c.rows, s.contacts.size);
  EXPECT_LT((c.contact.normal - Vec3::UnitZ()).norm(), 1e-6);
  EXPECT_NEAR(c.contact.multiplier, depth, clearance * depth);
  // Under the centre of mass: there is no moment, or the box would turn.
  const double radius = box->mass.radius;
  EXPECT_LT((c.contact.on_fixed - Vec3(0.02, -0.01, 0)).norm(), 1e-3 * radius);
  EXPECT_LT((c.contact.on_probe - Vec3(0.02, -0.01, 0)).norm(), 1e-3 * radius);
  EXPECT_NEAR(c.pitch, 0, 1e-6 * radius);
}

TEST(ContactClusters, a_box_in_a_groove_is_two_that_share_the_load) {
  // Two plates at a right angle, open upwards; the box stands on its edge between them.
  const Quat up = turn(pi / 4, Vec3::UnitX());
  PolygonSoup groove = test::box({1, 0.5, 0.1});
  const PolygonSoup wall = test::box({1, 0.1, 0.5});
  for (Vec3& x : groove.points) x += Vec3(0, 0.25, -0.05);
  const std::size_t first = groove.points.size();
  for (const Vec3& x : wall.points) groove.points.push_back(x + Vec3(0, -0.05, 0.25));
  for (auto polygon : wall.polygons) {
    for (auto& corner : polygon) corner += static_cast<decltype(+corner)>(first);
    groove.polygons.push_back(polygon);
  }
  const auto fixed = turned(groove, up);
  const auto box = test::body(test::box({0.2, 0.1, 0.1}));
  const double depth = 0.003;
  // The corner of a square of side a stands a/√2 under its middle.
  const Pose X{up, Vec3(0.01, 0, 0.1 / std::sqrt(2.0) - depth)};
  const Separation s = separate_static({box, fixed}, X);
  ASSERT_EQ(s.clusters.size, 2);
  EXPECT_NEAR(s.depth, depth, 2 * clearance * depth);
  for (const ContactCluster& c : s.clusters) {
    // 2 λ cos 45° = depth, and λ passes through the middle of the face.
    EXPECT_NEAR(share_of_force(c.contact, s.clusters), 0.5, 1e-3);
    EXPECT_NEAR(c.contact.multiplier, depth / std::sqrt(2.0), 1e-3 * depth);
    EXPECT_NEAR(c.contact.normal.z(), 1 / std::sqrt(2.0), 1e-6);
    const Vec3 lever = c.contact.on_probe - s.separated * box->mass.com;
    EXPECT_LT(lever.cross(c.contact.normal).norm(), 1e-3 * box->mass.radius);
  }
  EXPECT_LT(s.clusters[0].contact.normal.dot(s.clusters[1].contact.normal), 1e-6);
}

// A peg pushed aside and down in a square hole: each wall it meets pushes it back by its own part.
TEST(ContactClusters, where_nothing_pushes_no_contact_has_a_share) {
  ContactClusters none;
  none.items[0].contact.multiplier = 0;
  none.size = 1;
  EXPECT_EQ(share_of_force(none[0].contact, none), 0);
  EXPECT_EQ(share_of_force(Contact{}, ContactClusters{}), 0);
}

TEST(ContactClusters, a_peg_in_a_hole_has_one_a_wall) {
  const double wide = 0.1, gap = 0.002;
  const auto hole = blocks({{{0.3, 0.1, 0.2}, {0, (wide + gap + 0.1) / 2, 0}},
                            {{0.3, 0.1, 0.2}, {0, -(wide + gap + 0.1) / 2, 0}},
                            {{0.1, 0.3, 0.2}, {(wide + gap + 0.1) / 2, 0, 0}},
                            {{0.1, 0.3, 0.2}, {-(wide + gap + 0.1) / 2, 0, 0}},
                            {{0.4, 0.4, 0.1}, {0, 0, -0.1}}});
  const auto peg = test::body(test::box({wide, wide, 0.3}));
  const Vec3 pushed(0.003, -0.002, -0.0015);
  Pose X{Quat::Identity(), Vec3(gap / 2, -gap / 2, 0.1) + pushed};
  CoherentSolver solver({peg, hole});
  ASSERT_EQ(solver.reset({X.q, Vec3(0, 0, 0.11)}).status, Status::separated);
  const Separation s = solver.tick(X);
  ASSERT_EQ(s.status, Status::penetrating);
  ASSERT_EQ(s.clusters.size, 3);
  EXPECT_NEAR(s.depth, pushed.norm(), 1e-3 * pushed.norm());
  std::set<int> axes;
  for (const ContactCluster& c : s.clusters) {
    int axis = 0;
    EXPECT_GT(c.contact.normal.cwiseAbs().maxCoeff(&axis), 1 - 1e-6);
    axes.insert(axis);
    EXPECT_LT(c.contact.normal[axis] * pushed[axis], 0);
    EXPECT_NEAR(c.contact.multiplier, std::abs(pushed[axis]), 1e-3 * pushed.norm());
  }
  EXPECT_EQ(axes.size(), 3U);
}

Contact contact(const Vec3& at, const Vec3& normal, double multiplier) {
  return {at, at - 1e-6 * normal.normalized(), normal.normalized(), 1e-6, multiplier};
}

/// Forces and moments about the origin, added up one by one.
struct Sum {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  void add(const Contact& c, double pitch = 0) {
    force += c.multiplier * c.normal;
    moment += c.multiplier * (c.on_probe.cross(c.normal) + pitch * c.normal);
  }
};

TEST(ContactClusters, add_up_to_what_the_contacts_add_up_to) {
  std::mt19937_64 random(1);
  int merged = 0;
  for (int i = 0; i < 2000; ++i) {
    ContactSet contacts;
    const double spread = std::pow(10.0, test::uniform(random, -4, 0));
    for (int k = 0; k < 1 + i % ContactSet::capacity; ++k)
      contacts.push(contact(test::random_in_ball(random, spread),
                            Vec3::UnitZ() + test::random_in_ball(random, std::min(1.5, 3 * spread)),
                            test::uniform(random, 1e-6, 1)));
    const ContactClusters clusters = contact_clusters(contacts, 1);
    Sum by_contacts, by_clusters;
    int rows = 0;
    for (const Contact& c : contacts) by_contacts.add(c);
    for (const ContactCluster& c : clusters) {
      by_clusters.add(c.contact, c.pitch);
      rows += c.rows;
      EXPECT_GT(c.contact.multiplier, 0);
      EXPECT_NEAR(c.contact.normal.norm(), 1, 1e-12);
      EXPECT_EQ(c.id, 0U);
      merged += c.rows > 1;
    }
    EXPECT_EQ(rows, contacts.size);
    EXPECT_LT((by_contacts.force - by_clusters.force).norm(), 1e-13);
    EXPECT_LT((by_contacts.moment - by_clusters.moment).norm(), 1e-13);
  }
  EXPECT_GT(merged, 500);
}

TEST(ContactClusters, parallel_ones_have_no_couple_and_press_at_their_centre) {
  ContactSet contacts;
  contacts.push(contact({0, 0, 0}, Vec3::UnitZ(), 1));
  contacts.push(contact({4, 0, 0}, Vec3::UnitZ(), 3));
  const ContactClusters wide = contact_clusters(contacts, 1);
  ASSERT_EQ(wide.size, 1);
  EXPECT_EQ(wide[0].contact.multiplier, 4);
  EXPECT_LT((wide[0].contact.on_probe - Vec3(3, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(wide[0].pitch, 0, 1e-15);
  // Two steps of a stair are two, and so are the two sides of a wall.
  contacts.push(contact({4, 0, 0.5}, Vec3::UnitZ(), 1));
  contacts.push(contact({0, 0, 0}, -Vec3::UnitZ(), 1));
  EXPECT_EQ(contact_clusters(contacts, 1).size, 3);
}

TEST(ContactClusters, do_not_depend_on_the_order) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 300; ++i) {
    std::vector<Contact> all;
    for (int k = 0; k < 6; ++k)
      all.push_back(contact(test::random_in_ball(random, 0.3),
                            Vec3::UnitZ() + test::random_in_ball(random, 0.3),
                            test::uniform(random, 0.1, 1)));
    const auto sizes = [&] {
      ContactSet contacts;
      for (const Contact& c : all) contacts.push(c);
      std::multiset<int> out;
      for (const ContactCluster& c : contact_clusters(contacts, 1)) out.insert(c.rows);
      return out;
    };
    const auto expected = sizes();
    std::shuffle(all.begin(), all.end(), random);
    EXPECT_EQ(sizes(), expected);
  }
}

/// A floor of small triangles, bumpy by the height given, from −1 to 1.
std::shared_ptr<const Body> floor_of(int cells, double bumps, bool wall) {
  PolygonSoup out;
  const auto height = [&](double x, double y) { return bumps * std::sin(9 * x) * std::cos(7 * y); };
  const auto corner = [&](int i, int j) {
    const double x = 2.0 * i / cells - 1, y = 2.0 * j / cells - 1;
    out.points.push_back({x, y, height(x, y)});
    return out.points.size() - 1;
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      out.polygons.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)}),
          out.polygons.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
  if (wall) {
    const std::size_t first = out.points.size();
    for (const Vec3& x : {Vec3(0.5, -1, -1), Vec3(0.5, 1, -1), Vec3(0.5, 1, 1), Vec3(0.5, -1, 1)})
      out.points.push_back(x);
    out.polygons.push_back({first, first + 1, first + 2});
    out.polygons.push_back({first, first + 2, first + 3});
  }
  return test::body(out);
}

struct Slide {
  std::set<std::uint64_t> ids;
  int contacts = 0, places = 0;
};

/// Along x over the floor, `depth` under it; the ids of all clusters on the way.
Slide slide(CoherentSolver& solver, const Quat& q, double z) {
  Slide out;
  solver.reset({q, Vec3(-0.4, 0.03, 0.5)});
  std::set<std::pair<int, int>> cells;
  for (int i = 0; i <= 400; ++i) {
    const Separation& s = solver.tick({q, Vec3(-0.4 + 0.002 * i, 0.03, z)});
    if (s.status == Status::failed) ADD_FAILURE() << s.reason;
    for (const ContactCluster& c : s.clusters) {
      out.ids.insert(c.id);
      ++out.contacts;
      cells.insert({static_cast<int>(std::floor(50 * c.contact.on_fixed.x())),
                    static_cast<int>(std::floor(50 * c.contact.on_fixed.y()))});
    }
  }
  out.places = static_cast<int>(cells.size());
  return out;
}

TEST(ClusterIds, one_contact_keeps_its_id_over_many_triangles) {
  const auto ball = test::body(test::sphere(0.1, 24, 32));
  const auto corner = test::body(test::tetrahedron(0.2));
  const auto flat = floor_of(100, 0, false), bumpy = floor_of(100, 0.01, false);
  struct Case {
    std::shared_ptr<const Body> probe, fixed;
    double z;
  };
  for (const Case& c :
       {Case{ball, flat, 0.09}, Case{ball, bumpy, 0.07}, Case{corner, flat, 0.05}}) {
    CoherentSolver solver({c.probe, c.fixed});
    const Slide s = slide(solver, turn(0.3, Vec3(1, 2, 3).normalized()), c.z);
    EXPECT_EQ(s.ids.size(), 1U);
    EXPECT_GE(s.contacts, 400);
    EXPECT_GE(s.places, 35) << "cells of the floor that were slid over";
  }
}

TEST(ClusterIds, a_second_contact_gets_a_new_one_and_what_returns_another) {
  const auto ball = test::body(test::sphere(0.1, 24, 32));
  CoherentSolver solver({ball, floor_of(100, 0, true)});
  const auto ids = [&](double x, double z) {
    std::vector<std::uint64_t> out;
    for (const ContactCluster& c : solver.tick({Quat::Identity(), Vec3(x, 0, z)}).clusters)
      out.push_back(c.id);
    std::sort(out.begin(), out.end());
    return out;
  };
  using Ids = std::vector<std::uint64_t>;
  solver.reset({Quat::Identity(), Vec3(0, 0, 0.3)});
  EXPECT_EQ(ids(0, 0.2), Ids{});
  for (double x = 0; x < 0.39; x += 0.01) EXPECT_EQ(ids(x, 0.09), Ids{1}) << x;
  for (double x = 0.41; x < 0.5; x += 0.01) EXPECT_EQ(ids(x, 0.09), (Ids{1, 2})) << x;
  for (double z = 0.09; z < 0.11; z += 0.005) ids(0.45, z);
  EXPECT_EQ(ids(0.45, 0.12), Ids{2}) << "lifted off the floor";
  EXPECT_EQ(ids(0.45, 0.09), (Ids{2, 3})) << "a new touch of the floor";
  EXPECT_EQ(ids(0, 0.3), Ids{});
  EXPECT_EQ(ids(0, 0.09), Ids{4});
  solver.reset({Quat::Identity(), Vec3(0, 0, 0.09)});
  ASSERT_EQ(solver.last().clusters.size, 1);
  EXPECT_EQ(solver.last().clusters[0].id, 5U) << "never the same again";
}

TEST(ClusterIds, nothing_moves_and_nothing_changes_at_rest) {
  std::mt19937_64 random(3);
  for (const auto& pair : test::body_pairs(4)) {
    if (pair.name == "far") continue;  // rounding alone
    CoherentSolver solver({pair.a, pair.b});
    const double size = pair.b->mass.radius;
    solver.reset({test::random_rotation(random),
                  pair.b->mass.com + test::random_in_ball(random, 0.3 * size)});
    const Pose X = solver.last().device;
    Separation before = solver.last();
    for (int i = 0; i < 20; ++i) before = solver.tick(X);
    const Separation now = solver.tick(X);
    ASSERT_EQ(now.clusters.size, before.clusters.size) << pair.name;
    for (int i = 0; i < now.clusters.size; ++i)
      EXPECT_EQ(now.clusters[i].id, before.clusters[i].id) << pair.name;
  }
}

TEST(ClusterIds, seen_from_either_body_without_an_allocation) {
  // One point of the probe, sliding; one point of the fixed body, slid over; and a leap.
  const auto at = [](const Vec3& point) {
    ContactClusters out;
    out.items[0].contact = contact(point, Vec3::UnitZ(), 1);
    out.items[0].contact.on_fixed = point;
    out.size = 1;
    return out;
  };
  // The normals differ by more than lying in one plane would allow.
  ContactClusters one = at({0, 0, 0}), with_probe = at({0.5, 0, 0.2}),
                  with_fixed = at({0.5, 0, 0.2}), leapt = at({0.8, 0, 0.5});
  ClusterIds ids;
  test::AllocationCounter counter;
  ids.follow({}, 1, one);
  ids.follow({Quat::Identity(), Vec3(0.5, 0, 0.2)}, 1, with_probe);
  ids.follow({Quat::Identity(), Vec3(0, 0.4, 0)}, 1, with_fixed);
  ids.follow({Quat::Identity(), Vec3(0, 0.4, 0)}, 1, leapt);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0U);
  EXPECT_EQ(one.items[0].id, 1U);
  EXPECT_EQ(with_probe.items[0].id, 1U);
  EXPECT_EQ(with_fixed.items[0].id, 1U);
  EXPECT_EQ(leapt.items[0].id, 2U);
}

}  // namespace
}  // namespace sonde
