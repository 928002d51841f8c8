// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/contact_situations.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "engine/base/error.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

Contact contact_at(const Vec3& normal, const Vec3& at) {
  return {.on_probe = at, .on_fixed = at, .normal = normal.normalized(), .gap = 0, .multiplier = 1};
}
Separation separation(std::initializer_list<Contact> contacts) {
  Separation s;
  s.status = Status::penetrating;
  for (const Contact& c : contacts) s.contacts.push(c);
  s.clusters = contact_clusters(s.contacts, 0.1);
  return s;
}

TEST(ContactSituations, kinds_by_clusters_and_rows) {
  const Vec3 up = Vec3::UnitZ(), o = Vec3::Zero();
  EXPECT_EQ(contact_kind(separation({contact_at(up, o)})), ContactKind::flat);
  EXPECT_EQ(contact_kind(separation({contact_at(up, o), contact_at(up, {0.05, 0, 0})})),
            ContactKind::edge);
  EXPECT_EQ(contact_kind(separation(
                {contact_at(up, o), contact_at(up, {0.05, 0, 0}), contact_at(up, {0, 0.05, 0})})),
            ContactKind::conforming);
  EXPECT_EQ(contact_kind(separation({contact_at(up, o), contact_at(Vec3::UnitX(), {0.05, 0, 0})})),
            ContactKind::corner);
  EXPECT_EQ(contact_kind(separation({contact_at(up, o), contact_at(-up, {0.05, 0, 0})})),
            ContactKind::jammed);
}

SituationOptions options() {
  SituationOptions out;
  out.walks = 60;
  out.hardness = [](const FeltStiffness& felt) { return felt.object.norm(); };
  return out;
}

TEST(ContactSituations, of_a_box_on_a_box_are_ordered_and_the_same_each_time) {
  const auto probe = test::body(test::box({0.06, 0.05, 0.04}));
  const auto fixed = test::body(test::box({0.2, 0.2, 0.1}));
  const auto first = find_situations({probe, fixed}, {}, 3, options(), never);
  SituationOptions on_threads = options();
  on_threads.threads = 3;
  const auto second = find_situations({probe, fixed}, {}, 3, on_threads, never);
  ASSERT_EQ(first.size(), second.size());
  ASSERT_FALSE(first.empty());
  std::map<ContactKind, int> of_kind;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Separation& s = first[i].separation;
    EXPECT_EQ(s.sigma, second[i].separation.sigma);
    EXPECT_EQ(first[i].stiffness.object, second[i].stiffness.object);
    EXPECT_EQ(contact_kind(s), first[i].kind);
    EXPECT_GE(s.depth, 0.02 * probe->mass.radius);
    EXPECT_LE(++of_kind[first[i].kind], 3);
    if (i == 0) continue;
    EXPECT_LE(first[i - 1].kind, first[i].kind);
    if (first[i - 1].kind == first[i].kind) {
      EXPECT_GE(first[i - 1].stiffness.object.norm(), first[i].stiffness.object.norm());
    }
  }
}

TEST(ContactSituations, along_a_path_are_those_of_the_path) {
  const auto probe = test::body(test::box({0.06, 0.05, 0.04}));
  const auto fixed = test::body(test::box({0.2, 0.2, 0.1}));
  std::vector<TimedPose> path;
  for (int i = 0; i < 40; ++i)
    path.push_back({i * 1e-3, {Quat::Identity(), {0.01, 0, 0.08 - i * 5e-4}}});
  const auto found = situations_along({probe, fixed}, path, 2, options(), never);
  ASSERT_FALSE(found.empty());
  for (const ContactSituation& each : found) {
    EXPECT_EQ(each.separation.clusters.size, 1);  // face on face
    EXPECT_EQ(each.separation.device.p.x(), 0.01);
  }
  for (TimedPose& at : path) at.pose.p.z() += 1;
  EXPECT_TRUE(situations_along({probe, fixed}, path, 2, options(), never).empty());
}

TEST(ContactSituations, stop_when_asked) {
  const auto probe = test::body(test::box({0.06, 0.05, 0.04}));
  EXPECT_THROW(find_situations({probe, probe}, {}, 3, options(), [] { return true; }), Cancelled);
}

}  // namespace
}  // namespace sonde
