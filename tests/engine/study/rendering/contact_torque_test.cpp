// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/rendering/contact_torque.hpp"

#include <gtest/gtest.h>

#include "engine/penetration/search/static_search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

std::shared_ptr<const Body> block() { return test::body(test::box({2, 2, 0.1})); }

/// The lowest of the turned vertices, about the origin (these probes' centre of mass).
Vec3 lowest(const Body& body, const Quat& q) {
  Vec3 out = q * body.soup.vertices.front();
  for (const Vec3& v : body.soup.vertices)
    if ((q * v).z() < out.z()) out = q * v;
  return out;
}

Separation sunk(const Pair& pair, const Quat& q, double depth) {
  StaticOptions options;
  options.method = Method::pdt;
  const Vec3 at(0, 0, 0.05 - depth - lowest(pair.probe(), q).z());
  return separate_static(pair, {q, at}, options);
}

// Reference: a corner d below a large block's top. U = ½k d², and turning by δφ raises the corner
// by (δφ × r)·n: τ = k d r×n, r from the centre of mass to the corner.
TEST(ContactTorque, of_a_corner_is_what_the_energy_gives) {
  const auto probe = test::body(test::box({0.02, 0.03, 0.05}));
  const auto fixed = block();
  const Pair pair(probe, fixed);
  std::mt19937_64 random(3);
  for (int i = 0; i < 20; ++i) {
    const Quat q = test::random_rotation(random);
    const Vec3 want = lowest(*probe, q).cross(Vec3(0, 0, 0.004));
    const Vec3 got = ContactTorque(*probe, *fixed).at(sunk(pair, q, 0.004));
    EXPECT_LT((got - want).norm(), 2e-3 * 0.004 * probe->mass.radius) << i;
  }
}

// Reference: symmetry. A face on a face is carried about its middle: no torque.
TEST(ContactTorque, a_face_on_a_face_has_none) {
  const auto probe = test::body(test::box({0.02, 0.03, 0.05}));
  const auto fixed = block();
  const Separation s = sunk({probe, fixed}, Quat::Identity(), 0.004);
  ASSERT_EQ(s.status, Status::penetrating);
  EXPECT_LT(ContactTorque(*probe, *fixed).at(s).norm(), 2e-3 * 0.004 * probe->mass.radius);
}

TEST(ContactTorque, out_of_contact_there_is_none) {
  const auto probe = test::body(test::box({0.02, 0.03, 0.05}));
  const auto fixed = block();
  EXPECT_EQ(ContactTorque(*probe, *fixed).at(sunk({probe, fixed}, Quat::Identity(), -0.01)),
            Vec3::Zero().eval());
}

}  // namespace
}  // namespace sonde
