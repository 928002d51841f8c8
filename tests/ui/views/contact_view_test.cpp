// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/contact_view.hpp"

#include <gtest/gtest.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// Two contacts along z, of 1 mm at the origin and of 3 mm at x = 10 mm, with 4 N in all.
class ContactViewTest : public testing::Test {
 protected:
  void SetUp() override {
    ContactClusters& clusters = stage.snapshot.separation.clusters;
    clusters.size = 2;
    clusters.items[0].id = 4;
    clusters.items[0].contact.multiplier = 0.001;
    clusters.items[1].id = 7;
    clusters.items[1].contact.multiplier = 0.003;
    clusters.items[1].contact.on_fixed = Vec3(0.01, 0, 0);
    clusters.items[1].contact.on_probe = Vec3(0.01, 0, 0.00002);
    clusters.items[1].contact.gap = 0.00002;
    stage.snapshot.wrench.force = Vec3(0, 0, 4);
  }
  double length(std::size_t contact) const {
    const std::vector<Vec3>& stroke = view.labels().at(contact).stroke;
    return (stroke.back() - stroke.front()).norm();
  }
  Stage stage;
  ContactView view{*stage.renderer, stage.shapes};
};

TEST_F(ContactViewTest, each_has_its_points_and_a_normal_that_is_longer_for_a_larger_share) {
  view.show(stage.frame());
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 8u) << "of each two balls, a shaft and a head";
  EXPECT_NEAR((bounds_of(*seen[4]).center() - Vec3(0.01, 0, 0.00002)).norm(), 0, 1e-9);
  EXPECT_NEAR((bounds_of(*seen[5]).center() - Vec3(0.01, 0, 0)).norm(), 0, 1e-9);
  EXPECT_GT(length(1), length(0));
  const Vec3 tip = view.labels()[1].stroke.back();
  EXPECT_NEAR((tip - Vec3(0.01, 0, length(1))).norm(), 0, 1e-12) << "along the normal";
  EXPECT_NEAR(bounds_of(*seen[7]).max().z(), tip.z(), 1e-9);
  const double before = length(1);
  Frame far = stage.frame();
  far.pixel *= 2;
  view.show(far);
  EXPECT_DOUBLE_EQ(length(1), 2 * before) << "of one size on screen";
}

TEST_F(ContactViewTest, the_chosen_one_has_a_ring_its_force_and_its_gap) {
  view.show(stage.frame());
  EXPECT_TRUE(texts_of(view).isEmpty());
  view.choose(7);
  view.show(stage.frame());
  EXPECT_EQ(texts_of(view), QStringList{"contact 7: 3.00 N, gap 0.020 mm"});
  const auto seen = stage.seen();
  ASSERT_EQ(seen.size(), 10u);
  const Eigen::AlignedBox3d ring = bounds_of(*seen[0]);
  EXPECT_NEAR(ring.center().x(), 0.01, 2e-5);
  EXPECT_LT(ring.sizes().z(), 0.3 * ring.sizes().x()) << "square to the normal";
  view.choose(99);
  view.show(stage.frame());
  EXPECT_EQ(stage.seen().size(), 8u) << "it is gone";
}

TEST_F(ContactViewTest, out_of_contact_and_where_one_is_gone_nothing_stays) {
  view.choose(7);
  view.show(stage.frame());
  stage.snapshot.separation.clusters.size = 1;
  view.show(stage.frame());
  EXPECT_EQ(stage.seen().size(), 4u);
  stage.snapshot.separation.status = Status::separated;
  view.show(stage.frame());
  EXPECT_TRUE(stage.seen().empty());
  EXPECT_TRUE(view.labels().empty());
}

}  // namespace
}  // namespace sonde::ui::test
