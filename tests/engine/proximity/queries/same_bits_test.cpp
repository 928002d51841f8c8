// SPDX-License-Identifier: GPL-3.0-or-later
// The queries share constant data alone: any number of threads may ask at once, each gets the same
// bits, and nothing is allocated.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <thread>
#include <vector>

#include "engine/proximity/queries/distance.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "tests/support/adversarial.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/hard_motions.hpp"

namespace sonde {
namespace {

using test::BodyPair;
using test::HardMotion;

/// All that one place and one motion are asked.
struct Question {
  const BodyPair* pair;
  Transform X;
  double reach;
  HardMotion motion;
};

constexpr std::size_t most_rows = 64;
constexpr std::size_t numbers = 64 + 12 * most_rows;

/// Every number of every answer, as bits; room for all of them from the start.
class Answers {
 public:
  explicit Answers(std::size_t questions) : words_(questions * numbers) {}
  void add(double x) { std::memcpy(&words_[size_++], &x, sizeof x); }
  void add(const Vec3& x) {
    for (int i = 0; i < 3; ++i) add(x[i]);
  }
  const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t size_ = 0;
};

void answer(const Question& q, Answers& out) {
  const Body &a = *q.pair->a, &b = *q.pair->b;
  out.add(triangles_meet(a, b, q.X, Doubt::contact));
  out.add(overlap(a, b, q.X, Doubt::contact));
  for (const DistanceHint hint : {DistanceHint{}, DistanceHint{7, 3}}) {
    const Distance d = distance(a, b, q.X, hint);
    out.add(d.distance), out.add(d.on_a), out.add(d.on_b);
    out.add(d.triangle_a), out.add(d.triangle_b), out.add(d.overlapping);
  }
  std::array<NearPair, most_rows> rows;
  const NearPairs near = near_pairs(a, b, q.X, q.reach, rows);
  out.add(static_cast<double>(near.count)), out.add(near.reach);
  for (std::size_t i = 0; i < near.count; ++i) {
    const NearPair& p = rows[i];
    out.add(p.on_a), out.add(p.on_b), out.add(p.normal), out.add(p.gap);
    out.add(p.triangle_a), out.add(p.triangle_b);
  }
  const Sweep swept = sweep(a, b, q.motion.motion(), q.motion.clearance);
  out.add(swept.free_until), out.add(swept.hit);
  out.add(swept.triangle_a), out.add(swept.triangle_b);
}

std::vector<BodyPair> some_pairs() {
  std::mt19937_64 random(1);
  std::vector<BodyPair> out;
  for (int f = 0; f < test::families; ++f)
    for (int place = 0; place < static_cast<int>(test::Place::count); ++place)
      out.push_back(test::adversarial_pair(
          static_cast<test::Family>(f), static_cast<test::Place>(place), place ? 12 : 120, random));
  return out;
}

std::vector<Question> questions(const std::vector<BodyPair>& pairs) {
  std::mt19937_64 random(2);
  std::vector<Question> out;
  for (const BodyPair& pair : pairs)
    for (int i = 0; i < 24; ++i) {
      const auto kind = static_cast<HardMotion::Kind>(i % HardMotion::kinds);
      const auto motion = test::hard_motion(kind, pair, random);
      if (!motion) continue;
      const auto pose = static_cast<test::HardPose::Kind>(i % test::HardPose::kinds);
      out.push_back({&pair, test::hard_pose(pose, pair, random).X,
                     test::uniform(random, 0, 0.3) * pair.b->mass.radius, *motion});
    }
  return out;
}

std::vector<std::uint64_t> answers(const std::vector<Question>& all) {
  Answers out(all.size());
  for (const Question& q : all) answer(q, out);
  return out.words();
}

TEST(SameBits, from_any_number_of_threads) {
  const auto pairs = some_pairs();
  const auto all = questions(pairs);
  ASSERT_GT(all.size(), 900u);
  const auto alone = answers(all);
  for (const std::size_t threads : {1u, 2u, 4u}) {
    std::vector<std::vector<std::uint64_t>> got(threads);
    {
      std::vector<std::jthread> team;
      team.reserve(threads);
      for (auto& mine : got) team.emplace_back([&] { mine = answers(all); });
    }
    for (const auto& mine : got) EXPECT_TRUE(mine == alone) << threads << " threads";
  }
}

// What was asked before leaves no trace.
TEST(SameBits, in_any_order) {
  const auto pairs = some_pairs();
  const auto all = questions(pairs);
  const auto each = [&](const Question& q) {
    Answers out(1);
    answer(q, out);
    return out.words();
  };
  std::vector<std::vector<std::uint64_t>> forth;
  forth.reserve(all.size());
  for (const Question& q : all) forth.push_back(each(q));
  for (std::size_t i = all.size(); i-- > 0;) EXPECT_TRUE(each(all[i]) == forth[i]) << i;
}

TEST(SameBits, without_an_allocation) {
  const auto pairs = some_pairs();
  const auto all = questions(pairs);
  Answers out(all.size());
  test::AllocationCounter counter;
  for (const Question& q : all) answer(q, out);
  counter.stop();
  EXPECT_EQ(counter.allocations(), 0u);
  EXPECT_EQ(counter.frees(), 0u);
}

}  // namespace
}  // namespace sonde
