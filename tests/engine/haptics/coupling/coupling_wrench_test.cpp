// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the definition: σ is the mean squared displacement of the probe's points. The
// integrand is quadratic in the point, so a quadrature of degree two over the mesh's tetrahedra or
// triangles is exact, and knows nothing of centres of mass, inertia or principal axes.
#include "engine/haptics/coupling/coupling_wrench.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct Sample {
  Vec3 point;  ///< mesh frame
  double weight;
};

/// Exact for quadratics over the signed tetrahedra from the origin to each triangle.
void sample_solid(const Soup& soup, std::vector<Sample>& out) {
  const double a = (5 + 3 * std::sqrt(5.0)) / 20, b = (5 - std::sqrt(5.0)) / 20;
  for (const Triangle& t : soup.triangles) {
    const Vec3 c[4] = {Vec3::Zero(), soup.vertices[t[0]], soup.vertices[t[1]], soup.vertices[t[2]]};
    const double volume = c[1].dot(c[2].cross(c[3])) / 6;
    const Vec3 sum = c[0] + c[1] + c[2] + c[3];
    for (const Vec3& corner : c) out.push_back({b * sum + (a - b) * corner, volume / 4});
  }
}

/// Exact for quadratics over each triangle.
void sample_surface(const Soup& soup, std::vector<Sample>& out) {
  for (const Triangle& t : soup.triangles) {
    const Vec3 &a = soup.vertices[t[0]], &b = soup.vertices[t[1]], &c = soup.vertices[t[2]];
    const double area = (b - a).cross(c - a).norm() / 2;
    for (const Vec3& m : {Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)})
      out.push_back({m, area / 3});
  }
}

/// The points of a body, weighted, for exact means of quadratics.
struct Points {
  std::vector<Sample> samples;
  explicit Points(const Body& body) {
    body.solid ? sample_solid(body.soup, samples) : sample_surface(body.soup, samples);
    double total = 0;
    for (const Sample& s : samples) total += s.weight;
    for (Sample& s : samples) s.weight /= total;
  }
  Vec3 mean() const {
    Vec3 sum = Vec3::Zero();
    for (const Sample& s : samples) sum += s.weight * s.point;
    return sum;
  }
  double sigma(const Pose& X_FO, const Pose& X_FQ) const {
    double sum = 0;
    for (const Sample& s : samples)
      sum += s.weight * (X_FQ * s.point - X_FO * s.point).squaredNorm();
    return sum;
  }
};

PolygonSoup moved(PolygonSoup soup, const Pose& X) {
  for (Vec3& p : soup.points) p = X * p;
  return soup;
}

Pose random_pose(std::mt19937_64& random, double reach) {
  return {test::random_rotation(random), test::random_in_ball(random, reach)};
}

/// Off-centre and oblique in their mesh frames: mistakes about the frame must show.
std::vector<std::shared_ptr<const Body>> bodies() {
  std::mt19937_64 random(7);
  std::vector<std::shared_ptr<const Body>> out;
  const auto add = [&](const PolygonSoup& soup) {
    out.push_back(test::body(moved(soup, random_pose(random, 0.3))));
  };
  add(test::box({0.02, 0.05, 0.11}));
  add(test::torus_knot(2, 3, 0.05, 0.02, 0.01, 60, 8));
  add(test::random_soup(random, 12, 0.1));
  PolygonSoup wedge = test::tetrahedron(0.1);  // three different moments, none along a mesh axis
  wedge.points[0] += Vec3(0.1, 0.03, -0.02);
  add(wedge);
  return out;
}

/// O turned by the rotation vector about a point of the fixed frame.
Pose turned_about(const Pose& X, const Vec3& rotation, const Vec3& about) {
  const double angle = rotation.norm();
  const Quat q(Eigen::AngleAxisd(angle, angle > 0 ? Vec3(rotation / angle) : Vec3::UnitX()));
  return {(q * X.q).normalized(), about + q * (X.p - about)};
}

/// −∂U/∂O by central differences, U = ½ k σ.
Wrench wrench_by_differences(const Points& points, const Pose& X_FO, const Pose& X_FQ, double k) {
  const Vec3 com = X_FO * points.mean();
  const double step = 1e-5;
  const auto energy = [&](const Pose& X) { return k / 2 * points.sigma(X, X_FQ); };
  Wrench out;
  for (int i = 0; i < 3; ++i) {
    const Vec3 d = step * Vec3::Unit(i);
    const double length = 0.1;  // translations as large as what the rotations do
    const Pose ahead{X_FO.q, X_FO.p + length * d}, behind{X_FO.q, X_FO.p - length * d};
    out.force[i] = (energy(behind) - energy(ahead)) / (2 * step * length);
    out.torque[i] =
        (energy(turned_about(X_FO, -d, com)) - energy(turned_about(X_FO, d, com))) / (2 * step);
  }
  return out;
}

struct Relative {
  Vec3 v;
  double w;
};
Relative relative(const MassProperties& mass, const Pose& X_FO, const Pose& X_FQ) {
  const Quat q = X_FO.q.conjugate() * X_FQ.q;
  const double sign = q.w() < 0 ? -1 : 1;
  return {mass.R_MP.transpose() * (sign * q.vec()), sign * q.w()};
}

TEST(Coupling, sigma_is_the_mean_squared_displacement) {
  std::mt19937_64 random(1);
  for (const auto& body : bodies()) {
    const Points points(*body);
    for (int i = 0; i < 50; ++i) {
      const Pose O = random_pose(random, 0.1), Q = random_pose(random, 0.1);
      const Vec3 t = separation_motion(body->mass, O, Q).t;
      const Vec3 v = relative(body->mass, O, Q).v;
      const double sigma = t.squaredNorm() + 4 * v.dot(body->mass.inertia.cwiseProduct(v));
      EXPECT_NEAR(sigma, points.sigma(O, Q), 1e-12 * sigma);
    }
  }
}

TEST(Coupling, object_norm_wrench_is_the_gradient_of_the_energy) {
  std::mt19937_64 random(2);
  const double k = 700;
  for (const auto& body : bodies()) {
    const Points points(*body);
    for (int i = 0; i < 50; ++i) {
      const Pose O = random_pose(random, 0.1), Q = random_pose(random, 0.1);
      const Wrench got = object_norm_wrench(body->mass, O, Q, k);
      const Wrench want = wrench_by_differences(points, O, Q, k);
      EXPECT_LT((got.force - want.force).norm(), 1e-7 * want.force.norm());
      EXPECT_LT((got.torque - want.torque).norm(), 1e-7 * k * points.sigma(O, Q));
    }
  }
}

TEST(Coupling, the_reference_tells_the_two_signs_of_the_cross_term_apart) {
  std::mt19937_64 random(3);
  const auto body = bodies().front();
  const Points points(*body);
  const double k = 700;
  double largest = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose O = random_pose(random, 0.1), Q = random_pose(random, 0.1);
    const auto [v, w] = relative(body->mass, O, Q);
    const Vec3 Iv = body->mass.inertia.cwiseProduct(v);
    const Vec3 wrong = O.q * (body->mass.R_MP * Vec3(2 * k * (w * Iv - v.cross(Iv))));
    const Vec3 want = wrench_by_differences(points, O, Q, k).torque;
    largest = std::max(largest, (wrong - want).norm() / want.norm());
  }
  EXPECT_GT(largest, 0.03);
}

TEST(Coupling, the_torque_is_the_same_written_in_the_axes_at_either_pose) {
  std::mt19937_64 random(4);
  for (const auto& body : bodies())
    for (int i = 0; i < 50; ++i) {
      const Pose O = random_pose(random, 0.1), Q = random_pose(random, 0.1);
      const auto [v, w] = relative(body->mass, O, Q);
      const Vec3 Iv = body->mass.inertia.cwiseProduct(v);
      const Vec3 at_Q = Q.q * (body->mass.R_MP * Vec3(2 * 700 * (w * Iv + Iv.cross(v))));
      const Vec3 got = object_norm_wrench(body->mass, O, Q, 700).torque;
      EXPECT_LT((got - at_Q).norm(), 1e-12 * got.norm());
    }
}

TEST(Coupling, a_quaternion_and_its_negative_are_one_pose) {
  std::mt19937_64 random(5);
  const auto body = bodies().front();
  for (int i = 0; i < 50; ++i) {
    const Pose O = random_pose(random, 0.1), Q = random_pose(random, 0.1);
    Pose negative = Q;
    negative.q.coeffs() = -negative.q.coeffs();
    const Wrench a = object_norm_wrench(body->mass, O, Q, 700);
    const Wrench b = object_norm_wrench(body->mass, O, negative, 700);
    EXPECT_EQ(a.force, b.force);
    EXPECT_EQ(a.torque, b.torque);
    EXPECT_EQ(separation_motion(body->mass, O, Q).theta,
              separation_motion(body->mass, O, negative).theta);
  }
}

TEST(Coupling, no_separation_no_wrench) {
  std::mt19937_64 random(6);
  const auto body = bodies().front();
  const Pose O = random_pose(random, 0.1);
  const Wrench w = object_norm_wrench(body->mass, O, O, 700);
  EXPECT_EQ(w.force, Vec3::Zero());
  EXPECT_LT(w.torque.norm(), 1e-15);
}

TEST(Coupling, turning_about_an_axis_without_inertia_costs_nothing) {
  MassProperties line;  // along its first principal axis
  line.inertia = {0, 1e-4, 1e-4};
  const Pose O{Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY())), Vec3::Zero()};
  const Pose Q{O.q * Quat(Eigen::AngleAxisd(2.0, Vec3::UnitX())), Vec3::Zero()};
  EXPECT_LT(object_norm_wrench(line, O, Q, 700).torque.norm(), 1e-15);
}

TEST(Coupling, theta_is_the_rotation_vector_in_the_fixed_frame_at_any_angle) {
  std::mt19937_64 random(8);
  const auto body = bodies().front();
  const double pi = std::numbers::pi;
  for (const double angle : {0.0, 1e-300, 1e-160, 1e-9, 1e-3, 1.0, 3.0, pi - 1e-9}) {
    const Pose O = random_pose(random, 0.1);
    const Vec3 axis = test::random_in_ball(random, 1).normalized();
    // By hand: an AngleAxis of 1e-300 would be fine too, but this is what a small turn is.
    Quat turn(std::cos(angle / 2), 0, 0, 0);
    turn.vec() = std::sin(angle / 2) * axis;
    const Pose Q{turn * O.q, O.p};
    const Vec3 theta = separation_motion(body->mass, O, Q).theta;
    EXPECT_LT((theta - angle * axis).norm(), 1e-14 + 1e-8 * (angle > 3.1)) << angle;
  }
}

TEST(Coupling, t_is_the_displacement_of_the_centre_of_mass) {
  const auto body = bodies().front();
  const Pose O;
  const Vec3 com = Points(*body).mean();
  EXPECT_LT((body->mass.com - com).norm(), 1e-12);
  EXPECT_GT(com.norm(), 0.01);  // or the test below could not fail
  const Vec3 turn(0.4, -0.2, 0.9);
  EXPECT_LT(separation_motion(body->mass, O, turned_about(O, turn, com)).t.norm(), 1e-15);
  EXPECT_GT(separation_motion(body->mass, O, turned_about(O, turn, Vec3::Zero())).t.norm(), 1e-3);
}

TEST(Coupling, classic_wrench_is_spring_and_damper) {
  Coupling c;
  c.k_t = 300;
  c.k_r = 2;
  c.b_t = 5;
  c.b_r = 0.1;
  const SeparationMotion motion{{0.001, -0.002, 0.003}, {0.1, 0.2, -0.3}};
  const Wrench w = classic_wrench(motion, {0.01, 0.02, 0.03}, {1, -1, 2}, c);
  EXPECT_LT((w.force - Vec3(0.35, -0.5, 1.05)).norm(), 1e-14);
  EXPECT_LT((w.torque - Vec3(0.3, 0.3, -0.4)).norm(), 1e-14);
  EXPECT_FALSE(w.saturated);
}

TEST(Coupling, limits_keep_the_direction_and_set_the_flag) {
  const Wrench w{{3, 4, 0}, {0, 0.6, 0.8}, false};
  const Wrench both = limit(w, 2.5, 0.5);
  EXPECT_TRUE(both.saturated);
  EXPECT_LT((both.force - Vec3(1.5, 2, 0)).norm(), 1e-15);
  EXPECT_LT((both.torque - Vec3(0, 0.3, 0.4)).norm(), 1e-15);

  const Wrench force_only = limit(w, 2.5, 10);
  EXPECT_TRUE(force_only.saturated);
  EXPECT_EQ(force_only.torque, w.torque);
  const Wrench torque_only = limit(w, 10, 0.5);
  EXPECT_TRUE(torque_only.saturated);
  EXPECT_EQ(torque_only.force, w.force);
}

TEST(Coupling, below_the_limits_nothing_changes) {
  const Wrench w{{3, 4, 0}, {0, 0.6, 0.8}, false};
  const Wrench same = limit(w, 5, 1);
  EXPECT_FALSE(same.saturated);
  EXPECT_EQ(same.force, w.force);
  EXPECT_EQ(same.torque, w.torque);
}

TEST(Coupling, what_a_limit_has_cut_before_stays_marked_within_a_wider_one) {
  EXPECT_TRUE(limit({{3, 4, 0}, {0, 0.6, 0.8}, true}, 5, 1).saturated);
}

TEST(Coupling, what_is_no_number_never_reaches_the_hand) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf}) {
    const Wrench w = limit({{bad, 1, 0}, {0, bad, 0}, false}, 10, 1);
    EXPECT_EQ(w.force, Vec3::Zero());
    EXPECT_EQ(w.torque, Vec3::Zero());
    EXPECT_TRUE(w.saturated);
  }
  const Wrench huge = limit({{1e200, 0, 0}, {0, -1e300, 0}, false}, 10, 1);
  EXPECT_EQ(huge.force, Vec3(10, 0, 0));
  EXPECT_EQ(huge.torque, Vec3(0, -1, 0));
  EXPECT_EQ(limit({{1, 0, 0}, {0, 1, 0}, false}, nan, nan).force, Vec3::Zero());
  EXPECT_EQ(limit({{1, 0, 0}, {0, 1, 0}, false}, 0, 0).torque, Vec3::Zero());
}

}  // namespace
}  // namespace sonde
