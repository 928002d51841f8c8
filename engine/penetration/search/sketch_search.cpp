// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/sketch_search.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "engine/geometry/random.hpp"

namespace sonde {
namespace {

/// Starts between which what they found is shared.
constexpr std::size_t per_round = 8;
/// Of the depth: what ends no further than this from another end is at the same place.
constexpr double same_place = 0.1;
/// Of the depth: an end that is so much nearer than what was known of its place is worth a descent
/// of its own.
constexpr double news = 0.98;
/// Of the depth: where no other end is within this the best stands alone, and so many starts that
/// came to it are enough.
constexpr double alone = 1.08;
constexpr int agreeing_alone = 4;
constexpr int near_starts = 16;
/// Of the radius: the smallest ball in which a free pose is looked for.
constexpr double smallest_ball = 0.015;

}  // namespace

SketchSearch::SketchSearch(const Chart& chart, const SketchGoal& goal,
                           std::span<SketchDescent> lanes, ThreadPair& threads)
    : chart_(chart), goal_(goal), lanes_(lanes), threads_(threads) {}

void SketchSearch::go_on(int fewest, int most, int agreeing) {
  while (made_ < most && !(made_ >= fewest && is_clear(agreeing)))
    if (made_ > 0 && goal_.deadline.passed())
      return;
    else
      round();
}

bool SketchSearch::is_clear(int agreeing) const {
  int found = 0, beside = 0;
  for (const SketchEnd& end : ends_) {
    if (end.depth < 1.02 * ends_.front().depth) found += end.starts;
    beside += end.depth < alone * ends_.front().depth;
  }
  return found >= (beside == 1 ? std::min(agreeing, agreeing_alone) : agreeing);
}

double SketchSearch::best() const {
  return ends_.empty() ? goal_.beat : std::min(goal_.beat, ends_.front().depth);
}

void SketchSearch::round() {
  std::array<std::optional<SketchEnd>, per_round> found;
  threads_.each(per_round, [&](std::size_t k, std::size_t lane) {
    if (k >= lanes_.size() && goal_.deadline.passed()) return;
    found[k] = start(made_ + static_cast<int>(k), lanes_[lane]);
  });
  for (const auto& end : found)
    if (end) note(*end);
  std::ranges::stable_sort(ends_, {}, &SketchEnd::depth);
  made_ += int{per_round};
}

/// From the nearest free pose of ever larger balls; later also in balls about as large as the
/// best depth, and about the best ends.
std::optional<SketchEnd> SketchSearch::start(int number, SketchDescent& descent) const {
  Random random = stream(static_cast<std::uint64_t>(number));
  const double smallest = smallest_ball * chart_.mass().radius;
  if (ends_.empty()) return start_about(Vec6::Zero(), smallest, {1.6, 3}, random, descent);
  const int kind = number < near_starts ? 0 : number % int{per_round};
  if (kind < 3) return start_about(Vec6::Zero(), nearest_free_ / 2, {1.4, 12}, random, descent);
  if (kind < 5)
    return start_about(Vec6::Zero(), std::max(smallest, best() * random.uniform(0.8, 1.5)),
                       {1.25, 8}, random, descent);
  const auto which = static_cast<std::size_t>(number) % std::min<std::size_t>(3, ends_.size());
  auto end = start_about(ends_[which].y, std::max(smallest, best() * random.uniform(0.1, 0.6)),
                         {1.25, 8}, random, descent);
  if (end) end->starts = 0;  // it knew where to look
  return end;
}

std::optional<SketchEnd> SketchSearch::start_about(const Vec6& center, double ball,
                                                   const Balls& balls, Random& random,
                                                   SketchDescent& descent) const {
  for (; ball < 4 * chart_.mass().radius; ball *= balls.growth)
    for (int tries = 0; tries < balls.tries && !goal_.deadline.passed(); ++tries) {
      const Vec6 y = center + sample(random, ball);
      if (chart_.v(y).norm() > 0.9 || !descent.is_free(chart_, y)) continue;
      return descend(y, descent);
    }
  return std::nullopt;
}

/// By few points, and where that is promising by more.
std::optional<SketchEnd> SketchSearch::descend(const Vec6& y, SketchDescent& descent) const {
  const auto rough =
      descent.run(chart_, y, {.method = goal_.method, .rough = true, .beat = 0.95 * best()});
  if (rough.y.norm() > 1.15 * best()) return std::nullopt;
  const auto end = descent.run(chart_, rough.y, {.method = goal_.method, .beat = 1.1 * best()});
  if (!end.arrived) return std::nullopt;
  return SketchEnd{end.y, end.y.norm(), 1, y.norm()};
}

Vec6 SketchSearch::sample(Random& random, double ball) const {
  Vec6 y = random.in_ball(ball);
  y.tail<3>() = goal_.axes * y.tail<3>();
  for (int k = 0; k < 3; ++k)
    if (goal_.method == Method::pdt || !(chart_.mass().inertia[k] > 0)) y[k] = 0;
  return y;
}
Random SketchSearch::stream(std::uint64_t number) const {
  Random mixed(goal_.seed + 0x51ed270b0f5a1d27ULL * number);
  return Random(mixed.next());
}

void SketchSearch::note(const SketchEnd& end) {
  nearest_free_ = std::clamp(end.from, smallest_ball * chart_.mass().radius, nearest_free_);
  for (SketchEnd& known : ends_)
    if ((known.y - end.y).norm() < same_place * known.depth) {
      const int starts = known.starts + end.starts;
      const double came_to = end.depth < news * known.depth ? -1 : known.came_to;
      if (end.depth < known.depth) known = end;
      known.starts = starts;
      known.came_to = came_to;
      return;
    }
  ends_.push_back(end);
}

}  // namespace sonde
