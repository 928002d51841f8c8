// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/movement.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

const Place still_place{Vec3::UnitX(), Vec3::Zero(), Vec3::UnitZ(), {}, {}, 1};

TEST(MovementTest, trembling_within_half_a_pixel_is_rest) {
  Movement movement;
  Place place = still_place;
  const auto see = [&] { movement.see(place, Vec3::Zero(), 0.1, 1e-3); };
  see();
  EXPECT_FALSE(movement.going_on()) << "the first picture";
  for (const double tremble : {4e-4, -0.5e-4, 3e-4}) {
    place.device.p.x() = tremble;
    see();
  }
  EXPECT_FALSE(movement.going_on());
  place.device.q = Quat(Eigen::AngleAxisd(0.01, Vec3::UnitY()));
  see();
  EXPECT_TRUE(movement.going_on()) << "a point of the probe moves by a millimetre";
}

/// Each alone: the camera, the separated probe, the ghost. A pixel is 1 mm.
TEST(MovementTest, whatever_a_picture_shows_moves_it) {
  // Of many times, since a machine that does much else may look too late.
  const auto moves = [](const std::function<void(Place&)>& change) {
    bool any = false;
    for (int i = 0; i < 20; ++i) {
      Movement movement;
      Place place = still_place;
      movement.see(place, Vec3::Zero(), 0.1, 1e-3);
      change(place);
      movement.see(place, Vec3::Zero(), 0.1, 1e-3);
      any = any || movement.going_on();
    }
    return any;
  };
  EXPECT_FALSE(moves([](Place&) {}));
  EXPECT_TRUE(moves([](Place& place) { place.eye.y() += 1e-6; }));
  EXPECT_TRUE(moves([](Place& place) { place.up = Vec3::UnitY(); }));
  EXPECT_TRUE(moves([](Place& place) { place.separated.p.z() = 2e-3; }));
  EXPECT_FALSE(moves([](Place& place) { place.separated.p.z() = 4e-4; }));
  EXPECT_TRUE(moves([](Place& place) { place.swing = 0.99; }));
}

TEST(MovementTest, a_slow_drift_is_a_movement_in_the_end) {
  Movement movement;
  Place place = still_place;
  int seen = 0;
  for (int i = 0; i < 20; ++i) {  // a tenth of a pixel each
    place.device.p.x() = 1e-4 * i;
    movement.see(place, Vec3::Zero(), 0.1, 1e-3);
    seen += movement.going_on();
    if (seen) break;
  }
  EXPECT_EQ(seen, 1);
}

TEST(MovementTest, it_comes_to_rest_and_a_first_picture_has_not_moved) {
  Movement movement;
  Place place = still_place;
  const auto move_on = [&] {
    place.device.p.x() += 1;
    movement.see(place, Vec3::Zero(), 0.1, 1e-3);
  };
  need_application();
  for (int i = 0; i < 3; ++i) move_on();
  EXPECT_TRUE(wait_until([&] { return !movement.going_on(); }));
  move_on();
  movement.forget();
  EXPECT_FALSE(movement.going_on());
  move_on();
  EXPECT_FALSE(movement.going_on()) << "of another scene";
}

}  // namespace
}  // namespace sonde::ui::test
