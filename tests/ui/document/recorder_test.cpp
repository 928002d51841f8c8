// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/recorder.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sonde::ui::test {
namespace {

/// A probe in contact whose every number is noise: what compresses least.
class Noise {
 public:
  Snapshot next() {
    Snapshot tick;
    tick.tick = ++count_;
    tick.time = 1e-3 * static_cast<double>(count_);
    Separation& s = tick.separation;
    s.status = Status::penetrating;
    s.device = {Quat(random(), random(), random(), random()).normalized(), vector()};
    s.separated = {s.device.q, s.device.p + vector()};
    s.depth = random();
    for (int i = 0; i < 6; ++i)  // as many as hold a rigid body
      s.contacts.push({vector(), vector(), vector(), random(), random()});
    s.clusters.size = 3;
    tick.wrench = {vector(), vector()};
    tick.hand.energy = {random(), random(), random(), random()};
    tick.hand.rows.age = tick.hand.rows.reach = tick.hand.rows.refresh_us = random();
    tick.tick_us = random();
    return tick;
  }

 private:
  double random() { return std::normal_distribution<double>()(engine_); }
  Vec3 vector() { return {random(), random(), random()}; }
  std::mt19937_64 engine_{3};
  std::uint64_t count_ = 0;
};

TEST(Recorder, keeps_the_newest_ticks) {
  Recorder recorder;
  recorder.add(Snapshot{});
  EXPECT_EQ(recorder.ticks(), nullptr) << "there is no session";
  recorder.begin(0.05, 1000);
  Noise noise;
  for (int i = 0; i < 3000; ++i) recorder.add(noise.next());
  ASSERT_NE(recorder.ticks(), nullptr);
  EXPECT_EQ(recorder.ticks()->end(), 3000u);
  EXPECT_EQ(recorder.curves().size(), 3000u);
  EXPECT_EQ(recorder.curves().last_time(), recorder.ticks()->last_time());
}

TEST(Recorder, a_search_told_of_twice_is_kept_once) {
  Recorder recorder;
  recorder.begin(0.05, 1000);
  Noise noise;
  recorder.add(noise.next());
  BackgroundResult search;
  search.time_us = 3;
  recorder.add(search);
  recorder.add(search);
  search.time_us = 4;
  recorder.add(search);
  EXPECT_EQ(recorder.ticks()->searches().size(), 2u);
}

TEST(Recorder, Full_ten_minutes_of_noise_stay_within_the_memory) {
  Recorder recorder;
  recorder.begin(0.05, 1000);
  Noise noise;
  for (int i = 0; i < 700'000; ++i) recorder.add(noise.next());
  EXPECT_LE(recorder.ticks()->bytes() + recorder.curves().bytes(), Recorder::most_bytes);
  EXPECT_EQ(recorder.curves().size(), 600'000u);
}

}  // namespace
}  // namespace sonde::ui::test
