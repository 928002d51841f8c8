// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/sketch_search.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "engine/geometry/random.hpp"
#include "engine/penetration/descent/descent_tuning.hpp"

namespace sonde {
namespace {

/// Starts per round; results are shared between rounds. The first round begins near the device
/// pose; of later ones so many begin there, and so many as far away as the best depth, which alone
/// count as independent. The others begin about the best ends.
constexpr std::size_t sketches_a_round = 8;
constexpr int near_of_a_round = 1, far_of_a_round = 5;

}  // namespace

SketchSearch::SketchSearch(const Chart& chart, const SketchGoal& goal,
                           std::span<SketchDescent> lanes, ThreadPair& threads,
                           const SearchTuning& tuning)
    : chart_(chart), goal_(goal), lanes_(lanes), threads_(threads), tuned_(tuning) {}

void SketchSearch::make_starts(int most, int agreeing) {
  while (made_ < most && !is_clear(agreeing))
    if (made_ > 0 && goal_.deadline.passed())
      return;
    else
      round();
}

bool SketchSearch::is_clear(int agreeing) const {
  int found = 0;
  for (const SketchEnd& end : ends_)
    if (end.depth < (1 + tuned_.same) * ends_.front().depth) found += end.starts;
  return found >= agreeing;
}

double SketchSearch::best() const {
  return ends_.empty() ? goal_.beat : std::min(goal_.beat, ends_.front().depth);
}

void SketchSearch::round() {
  std::array<std::optional<SketchEnd>, sketches_a_round> found;
  threads_.each(sketches_a_round, [&](std::size_t k, std::size_t lane) {
    if (k >= lanes_.size() && goal_.deadline.passed()) return;
    found[k] = start(made_ + static_cast<int>(k), lanes_[lane]);
  });
  for (const auto& end : found)
    if (end) add(*end);
  std::ranges::stable_sort(ends_, {}, &SketchEnd::depth);
  made_ += int{sketches_a_round};
}

/// Starts from the nearest free pose of growing balls; later also from balls about as large as the
/// best depth, and from balls about the best ends.
std::optional<SketchEnd> SketchSearch::start(int number, SketchDescent& descent) const {
  Random random = stream(static_cast<std::uint64_t>(number));
  const double smallest = tuned_.smallest_ball * chart_.mass().radius;
  const auto not_independent = [](std::optional<SketchEnd> end) {
    if (end) end->starts = 0;
    return end;
  };
  if (ends_.empty()) return not_independent(start_about(Vec6::Zero(), smallest, random, descent));
  const int kind = number % int{sketches_a_round};
  if (kind < near_of_a_round)
    return not_independent(start_about(Vec6::Zero(), nearest_free_ / 2, random, descent));
  if (kind < near_of_a_round + far_of_a_round)
    return start_about(
        Vec6::Zero(),
        std::max(smallest, best() * random.uniform(tuned_.least_ball, tuned_.farthest_ball)),
        random, descent);
  const auto which = static_cast<std::size_t>(number) % std::min(tuned_.few_ends, ends_.size());
  return not_independent(
      start_about(ends_[which].y,
                  std::max(smallest, best() * random.uniform(tuned_.same_place, tuned_.end_ball)),
                  random, descent));
}

std::optional<SketchEnd> SketchSearch::start_about(const Vec6& center, double ball, Random& random,
                                                   SketchDescent& descent) const {
  // The first start always yields an end, however late.
  const bool must = ends_.empty() && made_ == 0;
  for (; ball < tuned_.largest_ball * chart_.mass().radius; ball *= tuned_.ball_growth)
    for (int tries = 0; tries < tuned_.tries_in_a_ball && (must || !goal_.deadline.passed());
         ++tries) {
      const Vec6 y = center + sample(random, ball);
      if (chart_.v(y).norm() > descent_tuning.largest_start_v || !descent.is_free(chart_, y))
        continue;
      return descend(y, descent);
    }
  return std::nullopt;
}

/// Descends with few points, and if that is promising with more.
std::optional<SketchEnd> SketchSearch::descend(const Vec6& y, SketchDescent& descent) const {
  const auto rough =
      descent.run(chart_, y, {.method = goal_.method, .rough = true, .beat = best()});
  if (rough.y.norm() > tuned_.rough_error * best()) return std::nullopt;
  const auto end =
      descent.run(chart_, rough.y, {.method = goal_.method, .beat = tuned_.rough_error * best()});
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

void SketchSearch::add(const SketchEnd& end) {
  nearest_free_ = std::clamp(end.from, tuned_.smallest_ball * chart_.mass().radius, nearest_free_);
  for (SketchEnd& known : ends_)
    if ((known.y - end.y).norm() < tuned_.same_place * known.depth) {
      const int starts = known.starts + end.starts;
      const double came_to = end.depth < (1 - tuned_.same) * known.depth ? -1 : known.came_to;
      if (end.depth < known.depth) known = end;
      known.starts = starts;
      known.came_to = came_to;
      return;
    }
  ends_.push_back(end);
}

}  // namespace sonde
