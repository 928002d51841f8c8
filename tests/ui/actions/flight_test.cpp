// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/flight.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/views/viewport_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// The cube of 100 mm, looked at from x.
class FlightTest : public ViewportAloneTest {
 protected:
  void SetUp() override {
    ViewportAloneTest::SetUp();
    if (HasFatalFailure()) return;
    look_from({0.5, 0, 0});
    flight = std::make_unique<Flight>(*view, nullptr);
  }
  void TearDown() override { flight.reset(); }
  /// Of the fixed body, at the middle of that side.
  static PointedPlace side(const Vec3& outward) {
    PointedPlace place;
    place.at = 0.05 * outward;
    place.outward = outward;
    place.size = 0.01;
    place.text = "here";
    return place;
  }
  /// Until it has landed; where the eye was meanwhile.
  std::vector<CameraPlace> fly() {
    std::vector<CameraPlace> seen;
    EXPECT_TRUE(wait_until([&] {
      seen.push_back(view->place());
      return !flight->flying();
    }));
    return seen;
  }
  std::unique_ptr<Flight> flight;
};

TEST_F(FlightTest, ends_before_the_place_with_a_ring_round_it) {
  const PointedPlace place = side(Vec3::UnitY());
  const CameraPlace wanted = view->before(place);
  flight->show(place);
  EXPECT_TRUE(flight->flying());
  fly();
  EXPECT_LT((view->place().position - wanted.position).norm(), 1e-6);
  EXPECT_LT((view->place().target - wanted.target).norm(), 1e-6);
  const auto drawn = [this] { return view->picture(now, {.size = {640, 480}}); };
  const QImage with_ring = drawn();
  view->point_out({});
  EXPECT_GT(pixels_between(with_ring, drawn()), 100);
}

/// Straight from one side to the other the eye would go through the body.
TEST_F(FlightTest, goes_round_what_it_looks_at) {
  const PointedPlace place = side(-Vec3::UnitX());
  const double from = (view->place().position - view->place().target).norm();
  const CameraPlace end = view->before(place);
  const double to = (end.position - end.target).norm();
  flight->show(place);
  for (const CameraPlace& at : fly()) {
    const double distance = (at.position - at.target).norm();
    EXPECT_GT(distance, 0.999 * std::min(from, to));
    EXPECT_LT(distance, 1.001 * std::max(from, to));
    EXPECT_GT((at.position - at.target).cross(at.up).norm(), 1e-6) << "up is not along the sight";
  }
  EXPECT_LT((view->place().position - end.position).norm(), 1e-6);
}

TEST_F(FlightTest, is_on_its_way_between_its_ends) {
  const CameraPlace start = view->place();
  const PointedPlace place = side(Vec3::UnitY());
  const CameraPlace end = view->before(place);
  flight->show(place);
  int between = 0;
  const std::vector<CameraPlace> seen = fly();
  for (const CameraPlace& at : seen)
    between +=
        (at.position - start.position).norm() > 1e-3 && (at.position - end.position).norm() > 1e-3;
  // A machine that draws its first frame after the flight's time sees its two ends only.
  EXPECT_TRUE(between > 0 || seen.size() < 3) << "the eye can follow";
}

TEST_F(FlightTest, another_place_takes_over_from_where_the_eye_is) {
  flight->show(side(Vec3::UnitY()));
  const CameraPlace start = view->place();
  ASSERT_TRUE(wait_until([&] {
    return !flight->flying() || (view->place().position - start.position).norm() > 0.01;
  }));
  const CameraPlace meanwhile = view->place();
  const PointedPlace second = side(-Vec3::UnitY());
  const CameraPlace wanted = view->before(second);
  flight->show(second);
  EXPECT_LT((view->place().position - meanwhile.position).norm(), 1e-6) << "nothing jumps";
  fly();
  EXPECT_LT((view->place().position - wanted.position).norm(), 1e-6);
}

TEST_F(FlightTest, stopped_the_camera_stays) {
  flight->show(side(Vec3::UnitY()));
  flight->stop();
  EXPECT_FALSE(flight->flying());
  const CameraPlace there = view->place();
  wait(600);  // longer than a flight takes
  EXPECT_EQ(view->place().position, there.position);
  EXPECT_EQ(view->place().target, there.target);
}

}  // namespace
}  // namespace sonde::ui::test
