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
constexpr int near_starts = 16;
/// Of the radius: the smallest ball in which a free pose is looked for.
constexpr double smallest_ball = 0.015;

class Search {
 public:
  Search(const Chart& chart, const SketchSearch& search, std::span<SketchDescent> lanes,
         ThreadPair& threads)
      : chart_(chart), search_(search), lanes_(lanes), threads_(threads) {}

  std::vector<SketchEnd> run() {
    for (int first = 0; first < search_.most && !enough(first); first += int{per_round})
      round(first);
    return std::move(ends_);
  }

 private:
  static bool nearer(const SketchEnd& a, const SketchEnd& b) { return a.depth < b.depth; }

  bool enough(int made) const {
    if (made > 0 && search_.deadline.passed()) return true;
    int agreeing = 0;
    for (const SketchEnd& end : ends_)
      if (end.depth < 1.02 * best()) agreeing += end.starts;
    return made >= search_.fewest && agreeing >= search_.fewest / 4;
  }
  double best() const {
    return ends_.empty() ? std::numeric_limits<double>::infinity() : ends_.front().depth;
  }

  void round(int first) {
    std::array<std::optional<SketchEnd>, per_round> found;
    threads_.each(per_round, [&](std::size_t k, std::size_t lane) {
      if (k >= lanes_.size() && search_.deadline.passed()) return;
      found[k] = start(first + static_cast<int>(k), lanes_[lane]);
    });
    for (const auto& end : found)
      if (end) note(*end);
    std::ranges::stable_sort(ends_, nearer);
  }

  /// From the nearest free pose of ever larger balls; later also in balls about as large as the
  /// best depth, and about the best ends.
  std::optional<SketchEnd> start(int number, SketchDescent& descent) const {
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

  struct Balls {
    double growth;
    int tries;  // in each
  };
  std::optional<SketchEnd> start_about(const Vec6& center, double ball, const Balls& balls,
                                       Random& random, SketchDescent& descent) const {
    for (; ball < 4 * chart_.mass().radius; ball *= balls.growth)
      for (int tries = 0; tries < balls.tries && !search_.deadline.passed(); ++tries) {
        const Vec6 y = center + sample(random, ball);
        if (chart_.v(y).norm() > 0.9 || !descent.is_free(chart_, y)) continue;
        return descend(y, descent);
      }
    return std::nullopt;
  }

  /// By few points, and where that is promising by more.
  std::optional<SketchEnd> descend(const Vec6& y, SketchDescent& descent) const {
    const auto rough =
        descent.run(chart_, y, {.method = search_.method, .rough = true, .beat = 0.95 * best()});
    if (rough.y.norm() > 1.15 * best()) return std::nullopt;
    const auto end = descent.run(chart_, rough.y, {.method = search_.method, .beat = 1.1 * best()});
    if (!end.arrived) return std::nullopt;
    return SketchEnd{end.y, end.y.norm(), 1, y.norm()};
  }

  Vec6 sample(Random& random, double ball) const {
    Vec6 y = random.in_ball(ball);
    y.tail<3>() = search_.axes * y.tail<3>();
    for (int k = 0; k < 3; ++k)
      if (search_.method == Method::pdt || !(chart_.mass().inertia[k] > 0)) y[k] = 0;
    return y;
  }
  Random stream(std::uint64_t number) const {
    Random mixed(search_.seed + 0x51ed270b0f5a1d27ULL * number);
    return Random(mixed.next());
  }

  void note(const SketchEnd& end) {
    nearest_free_ = std::clamp(end.from, smallest_ball * chart_.mass().radius, nearest_free_);
    for (SketchEnd& known : ends_)
      if ((known.y - end.y).norm() < same_place * known.depth) {
        const int starts = known.starts + end.starts;
        if (end.depth < known.depth) known = end;
        known.starts = starts;
        return;
      }
    ends_.push_back(end);
  }

  const Chart& chart_;
  const SketchSearch& search_;
  std::span<SketchDescent> lanes_;
  ThreadPair& threads_;
  std::vector<SketchEnd> ends_;                                    // the nearest first
  double nearest_free_ = std::numeric_limits<double>::infinity();  // m, where a start began
};

}  // namespace

std::vector<SketchEnd> search_sketches(const Chart& chart, const SketchSearch& search,
                                       std::span<SketchDescent> lanes, ThreadPair& threads) {
  return Search(chart, search, lanes, threads).run();
}

}  // namespace sonde
