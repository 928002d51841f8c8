// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/rendering/rendering.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::never;

RenderSetup box_on_block() {
  RenderSetup out{
      .pair = {test::body(test::box({0.02, 0.03, 0.05})), test::body(test::box({0.3, 0.3, 0.1}))}};
  out.coupling.k = 400;
  out.coupling.max_force = 0.5;  // does not act
  return out;
}

/// Straight down into the block and up again, 10 mm deep in the middle.
std::vector<TimedPose> press() {
  std::vector<TimedPose> out;
  for (int i = 0; i <= 40; ++i)
    out.push_back(
        {0.001 * i, {Quat::Identity(), Vec3(0, 0, 0.065 + 0.001 * (i < 20 ? 20 - i : i - 20))}});
  return out;
}

// Reference: a box flat on a block: depth is how far its lower face is below the upper one.
TEST(Rendering, a_box_pressed_on_a_block) {
  for (const Method method : {Method::pdg, Method::pdt}) {
    const Rendering r = render(box_on_block(), method, press(), never);
    ASSERT_EQ(r.size(), 41u);
    EXPECT_EQ(r[0].force, Vec3::Zero().eval());
    EXPECT_EQ(r[0].moved, 0);
    EXPECT_NEAR(r[7].moved, 0.001, 1e-12);
    EXPECT_NEAR(r[20].depth, 0.010, 2e-5);
    EXPECT_LT((r[20].force - Vec3(0, 0, 4)).norm(), 0.02) << "not cut at the device's limit";
    EXPECT_LT(r[20].torque.norm(), 1e-3);
    EXPECT_EQ(r[40].depth, 0);
    for (const RenderedTick& tick : r) EXPECT_FALSE(tick.failed || tick.jumped);
  }
}

TEST(Rendering, the_same_bits_after_being_written_and_read) {
  const Rendering once = render(box_on_block(), Method::pdg, press(), never);
  const std::string text = to_json(once);
  EXPECT_EQ(to_json(rendering_of(text, "part")), text);
  EXPECT_EQ(to_json(render(box_on_block(), Method::pdg, press(), never)), text);
  EXPECT_EQ(rendering_of(text, "part")[20].force, once[20].force);
  for (const char* wrong : {"", "{}", "{\"ticks\":[[1,2]]}", "[]"})
    EXPECT_THROW(rendering_of(wrong, "part"), InputError) << wrong;
}

TEST(Rendering, can_be_stopped) {
  int asked = 0;
  EXPECT_THROW(render(box_on_block(), Method::pdg, press(), [&] { return ++asked > 5; }),
               Cancelled);
}

}  // namespace
}  // namespace sonde
