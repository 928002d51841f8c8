// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/recorded_tick.hpp"

#include <stdexcept>
#include <string>

#include "tests/engine/recording/made_up_ticks.hpp"

namespace sonde::test {
namespace {

/// The float nearest to a number, which is what most columns keep.
double kept(double x) { return static_cast<double>(static_cast<float>(x)); }

void expect_kept(const Vec3& read, const Vec3& written) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(read[i], kept(written[i]));
}

void expect_same_contacts(const Separation& a, const Separation& b) {
  ASSERT_EQ(a.contacts.size, b.contacts.size);
  for (int c = 0; c < a.contacts.size; ++c) {
    expect_kept(a.contacts[c].on_probe, b.contacts[c].on_probe);
    expect_kept(a.contacts[c].on_fixed, b.contacts[c].on_fixed);
    expect_kept(a.contacts[c].normal, b.contacts[c].normal);
    EXPECT_EQ(a.contacts[c].gap, kept(b.contacts[c].gap));
    EXPECT_EQ(a.contacts[c].multiplier, kept(b.contacts[c].multiplier));
  }
  ASSERT_EQ(a.clusters.size, b.clusters.size);
  for (int c = 0; c < a.clusters.size; ++c) {
    EXPECT_EQ(a.clusters[c].id, b.clusters[c].id);
    EXPECT_EQ(a.clusters[c].rows, b.clusters[c].rows);
    EXPECT_NEAR(a.clusters[c].contact.multiplier, b.clusters[c].contact.multiplier, 1e-8);
    EXPECT_LT((a.clusters[c].contact.on_probe - b.clusters[c].contact.on_probe).norm(), 1e-6);
  }
}

void expect_same_separation(const Separation& a, const Separation& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_STREQ(a.reason, b.reason);
  EXPECT_EQ(a.device.p, b.device.p);
  EXPECT_EQ(a.device.q.coeffs(), b.device.q.coeffs());
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.sigma, b.sigma);
  EXPECT_LT((a.separated.p - b.separated.p).norm(), 1e-9);
  EXPECT_LT(a.separated.q.angularDistance(b.separated.q), 1e-6);
  EXPECT_EQ(a.residual, kept(b.residual));
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.converged, b.converged);
  EXPECT_EQ(a.jumped, b.jumped);
  EXPECT_EQ(a.translation, kept(b.translation));
  EXPECT_EQ(a.rotation, kept(b.rotation));
  expect_same_contacts(a, b);
}

void expect_same_hand(const HandState& a, const HandState& b) {
  EXPECT_EQ(a.withheld, b.withheld);
  EXPECT_EQ(a.share, kept(b.share));
  EXPECT_EQ(a.slewed, b.slewed);
  EXPECT_EQ(a.held, b.held);
  EXPECT_EQ(a.energy.given, b.energy.given);
  EXPECT_EQ(a.energy.excess, kept(b.energy.excess));
  EXPECT_EQ(a.energy.dissipated, kept(b.energy.dissipated));
  EXPECT_EQ(a.energy.damping, kept(b.energy.damping));
  EXPECT_EQ(a.rows.age_ticks, b.rows.age_ticks);
  EXPECT_EQ(a.rows.age, kept(b.rows.age));
  EXPECT_EQ(a.rows.in_step, b.rows.in_step);
  EXPECT_EQ(a.rows.held_back, b.rows.held_back);
  EXPECT_EQ(a.rows.reach, kept(b.rows.reach));
  EXPECT_EQ(a.rows.refresh_us, kept(b.rows.refresh_us));
}

TEST(RecordedTick, poses_depths_times_and_gains_come_back_to_the_bit) {
  const std::vector<Snapshot> written = made_up_ticks(400);
  const std::vector<Snapshot> read = ticks_in(tick_content(written), made_up_radius);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    SCOPED_TRACE(i);
    const Snapshot &a = read[i], &b = written[i];
    EXPECT_EQ(a.tick, b.tick);
    EXPECT_EQ(a.time, b.time);
    expect_same_separation(a.separation, b.separation);
    expect_kept(a.wrench.force, b.wrench.force);
    expect_kept(a.wrench.torque, b.wrench.torque);
    EXPECT_EQ(a.wrench.saturated, b.wrench.saturated);
    expect_same_hand(a.hand, b.hand);
    EXPECT_EQ(a.tick_us, kept(b.tick_us));
    EXPECT_EQ(a.rate_hz, kept(b.rate_hz));
    EXPECT_EQ(a.late, b.late);
    EXPECT_EQ(a.coupling.mode, b.coupling.mode);
    EXPECT_EQ(a.coupling.k, b.coupling.k);
    EXPECT_EQ(a.coupling.b_t, b.coupling.b_t);
    EXPECT_FALSE(a.paused);
  }
}

TEST(RecordedTick, what_was_read_is_written_as_the_same_bytes) {
  const std::string first =
      tick_content(ticks_in(tick_content(made_up_ticks(100)), made_up_radius));
  EXPECT_EQ(tick_content(ticks_in(first, made_up_radius)).size(), first.size());
}

TEST(RecordedTick, a_turn_of_half_a_circle_comes_back) {
  std::vector<Snapshot> ticks(1);
  Separation& s = ticks[0].separation;
  s.status = Status::penetrating;
  s.separated.q = Quat(0, 1, 0, 0);
  const Snapshot read = ticks_in(tick_content(ticks), made_up_radius).front();
  EXPECT_LT(read.separation.separated.q.angularDistance(s.separated.q), 1e-6);
}

TEST(RecordedTick, searches_come_back_to_the_bit) {
  std::vector<RecordedSearch> written(3);
  written[0].time = 1.5;
  written[0].result.device.p = Vec3(1, 2, 1.0 / 3);
  written[1].result.nearest = FoundSeparation{0.1, {Quat(0.6, 0.8, 0, 0), Vec3(4, 5, 6)}};
  written[1].result.lower_bound = 0.05;
  written[2].result.pdt = FoundSeparation{0, {Quat(0, 0, 0, 1), Vec3(7, 8, 9)}};
  written[2].result.time_us = 123;
  const std::vector<RecordedSearch> read = searches_in(search_content(written));
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].time, 1.5);
  EXPECT_EQ(read[0].result.device.p, written[0].result.device.p);
  EXPECT_FALSE(read[0].result.nearest || read[0].result.pdt || read[0].result.lower_bound);
  ASSERT_TRUE(read[1].result.nearest && !read[1].result.pdt);
  EXPECT_EQ(read[1].result.nearest->depth, 0.1);
  EXPECT_EQ(read[1].result.nearest->separated.q.coeffs(),
            written[1].result.nearest->separated.q.coeffs());
  EXPECT_EQ(read[1].result.lower_bound, 0.05);
  ASSERT_TRUE(read[2].result.pdt);
  EXPECT_EQ(read[2].result.pdt->depth, 0);
  EXPECT_EQ(read[2].result.pdt->separated.p, Vec3(7, 8, 9));
  EXPECT_EQ(read[2].result.time_us, 123);
}

TEST(RecordedTick, content_cut_anywhere_is_refused) {
  const std::string content = tick_content(made_up_ticks(20));
  for (std::size_t size = 0; size < content.size(); ++size)
    EXPECT_THROW(ticks_in(std::string_view(content).substr(0, size), made_up_radius),
                 std::invalid_argument)
        << size;
}

}  // namespace
}  // namespace sonde::test
