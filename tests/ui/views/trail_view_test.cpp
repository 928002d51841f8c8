// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/trail_view.hpp"

#include <gtest/gtest.h>
#include <vtkDataSet.h>
#include <vtkMapper.h>

#include "tests/ui/views/stage.hpp"

namespace sonde::ui::test {
namespace {

/// The hand goes along x by 1 m/s; the probe is held 10 mm above it. The centre of mass is 1 m
/// along y.
class TrailViewTest : public testing::Test {
 protected:
  void SetUp() override { stage.mass.com = Vec3(0, 1, 0); }
  void show_at(double time) {
    stage.snapshot.time = time;
    stage.snapshot.separation.device.p = Vec3(time, 0, 0);
    stage.snapshot.separation.separated.p = Vec3(time, 0, 0.01);
    view.show(stage.frame());
  }
  std::vector<double> times(std::size_t line) {
    vtkDataSet& data = *stage.seen().at(line)->GetMapper()->GetInputAsDataSet();
    std::vector<double> out;
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) out.push_back(data.GetPoint(i)[0]);
    return out;
  }
  Stage stage;
  TrailView view{*stage.renderer};
};

TEST_F(TrailViewTest, leads_through_the_centres_of_mass_at_the_hand_and_as_held) {
  show_at(1);
  EXPECT_TRUE(stage.seen().empty()) << "one place is no path";
  show_at(2);
  show_at(3);
  ASSERT_EQ(stage.seen().size(), 2u);
  EXPECT_EQ(times(0), (std::vector<double>{1, 2, 3}));
  const Eigen::AlignedBox3d hand = bounds_of(*stage.seen()[0]), held = bounds_of(*stage.seen()[1]);
  EXPECT_NEAR((hand.min() - Vec3(1, 1, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((hand.max() - Vec3(3, 1, 0)).norm(), 0, 1e-6);
  EXPECT_NEAR((held.max() - Vec3(3, 1, 0.01)).norm(), 0, 1e-6);
}

TEST_F(TrailViewTest, what_is_older_than_four_seconds_is_left_out) {
  for (int i = 0; i <= 10; ++i) show_at(i);
  EXPECT_EQ(times(0), (std::vector<double>{6, 7, 8, 9, 10}));
}

TEST_F(TrailViewTest, another_run_and_what_was_not_watched_begin_anew) {
  show_at(5);
  show_at(6);
  show_at(1);  // time falls
  EXPECT_TRUE(stage.seen().empty());
  show_at(2);
  EXPECT_EQ(times(1), (std::vector<double>{1, 2}));
  view.set_visible(false);
  show_at(2.5);
  EXPECT_TRUE(stage.seen().empty());
  view.set_visible(true);
  show_at(3);
  show_at(4);
  EXPECT_EQ(times(0), (std::vector<double>{3, 4}));
  view.clear();
  show_at(4.5);
  EXPECT_TRUE(stage.seen().empty());
}

}  // namespace
}  // namespace sonde::ui::test
