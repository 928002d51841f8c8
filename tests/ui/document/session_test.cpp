// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/session.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "tests/support/temp_folder.hpp"
#include "ui/document/endings.hpp"

namespace sonde::ui::test {
namespace {

/// Two crumpled soups of the bundled scenes, one in the other: a search there takes a while.
class SessionTest : public ::testing::Test {
 protected:
  SessionTest()
      : session(std::make_unique<Session>(
            open_scene(SONDE_RESOURCES "/scenes/crumpled-soup.sonde.json"))) {}

  Pose at(double x) const {
    Pose X_FM = session->loaded().start;
    X_FM.p = session->fixed().mass.com - X_FM.q * session->probe().mass.com;
    X_FM.p.x() += x * session->fixed().mass.radius;
    return X_FM;
  }
  /// The first snapshot after a place; null where none comes.
  const Snapshot* first() {
    for (int i = 0; i < 6000; ++i) {
      if (const Snapshot* now = session->latest()) return now;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return nullptr;
  }
  std::unique_ptr<Session> session;
};

TEST_F(SessionTest, of_several_places_the_newest_counts) {
  for (const double x : {0.3, 0.2, 0.1}) session->place(at(x));
  EXPECT_EQ(session->device_pose().p, at(0.1).p);
  const Snapshot* now = first();
  ASSERT_TRUE(now);
  EXPECT_EQ(now->separation.device.p, at(0.1).p) << "no other is ever shown";
  EXPECT_FALSE(session->placing());
}

// A dragged probe goes to each target in the time between two; a placed one is there.
TEST_F(SessionTest, a_placed_probe_does_not_come_from_where_it_was_dragged) {
  ASSERT_TRUE(first());
  const double free = 4;  // no search
  for (const bool pauses : {true, false}) {
    for (int i = 0; i < 20; ++i) {
      session->set_device_pose(at(free + 0.05 * i));
      std::this_thread::sleep_for(std::chrono::milliseconds(i < 19 ? 100 : 5));
    }
    session->set_paused(pauses);
    std::this_thread::sleep_for(std::chrono::milliseconds(pauses ? 20 : 0));
    session->place(at(-free));
    const Snapshot* now = first();
    ASSERT_TRUE(now);
    EXPECT_EQ(now->separation.device.p, at(-free).p) << pauses;
  }
}

TEST_F(SessionTest, what_is_said_while_it_searches_holds_when_it_has_found) {
  session->place(at(0.1));
  Coupling gains = session->coupling();
  gains.k *= 2;
  session->set_coupling(gains);
  session->set_force(false);
  session->set_paused(true);
  session->set_paused(false);
  ASSERT_TRUE(first());
  for (int i = 0; i < 2000 && session->latest()->coupling.k != gains.k; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const Snapshot* now = session->latest();
  EXPECT_EQ(now->coupling.k, gains.k);
  EXPECT_EQ(now->wrench.force, Vec3::Zero());
  EXPECT_EQ(now->hand.withheld, Withheld::stopped);
}

TEST_F(SessionTest, while_it_searches_the_probe_is_where_it_is_placed) {
  ASSERT_TRUE(first());
  Pose far = at(0.1);
  far.p.x() += 10 * session->fixed().mass.radius;
  session->replay({{0, far}});  // what the servo says is asked for, not what the mouse wants
  session->place(at(0.1));
  for (;;) {
    const Pose is = session->device_pose();
    if (!session->placing()) break;
    ASSERT_EQ(is.p, at(0.1).p);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(first());
}

TEST_F(SessionTest, it_can_end_while_it_searches) {
  Endings endings;
  session->place(at(0.1));
  session->place(at(0.2));
  endings.add(std::move(session));
  endings.add(nullptr);
}

}  // namespace
}  // namespace sonde::ui::test
