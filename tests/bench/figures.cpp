// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/figures.hpp"

#include <algorithm>
#include <map>

#include "engine/text/number_text.hpp"

namespace sonde::bench {
namespace {

/// The calls of both sides at the poses that both were timed at, and of ours at all.
struct Pool {
  Calls ours_all, ours_common, theirs;
  std::size_t compared = 0, missed = 0;

  void add(const Calls& our_calls) {
    ours_all.insert(ours_all.end(), our_calls.begin(), our_calls.end());
  }
  void add_common(const Calls& our_calls, const LibraryResult& other) {
    const std::size_t common = std::min(our_calls.size(), other.calls.size());
    const auto end = static_cast<std::ptrdiff_t>(common);
    ours_common.insert(ours_common.end(), our_calls.begin(), our_calls.begin() + end);
    theirs.insert(theirs.end(), other.calls.begin(), other.calls.begin() + end);
    compared += other.compared;
    missed += other.missed;
  }
  void add(const Pool& pool) {
    ours_all.insert(ours_all.end(), pool.ours_all.begin(), pool.ours_all.end());
    ours_common.insert(ours_common.end(), pool.ours_common.begin(), pool.ours_common.end());
    theirs.insert(theirs.end(), pool.theirs.begin(), pool.theirs.end());
    compared += pool.compared;
    missed += pool.missed;
  }
  std::optional<double> ratio() const {
    if (theirs.empty()) return {};
    return ratio_of_medians(theirs, ours_common);
  }
  double median_us() const { return median(times_of_poses(ours_all)); }
};

using Pools = std::map<std::string, Pool>;  // by pair

Pools pools_of(const std::vector<Result>& results, const Figure& figure) {
  Pools out;
  for (const Result& result : results) {
    const bool asked =
        std::find(figure.poses.begin(), figure.poses.end(), result.poses) != figure.poses.end();
    const LibraryResult* mine = result.find(ours);
    if (result.scale || result.query != figure.query || !asked || !mine || mine->calls.empty())
      continue;
    Pool& pool = out[result.pair];
    pool.add(mine->calls);
    const LibraryResult* other = result.find(figure.against);
    if (other && !other->calls.empty()) pool.add_common(mine->calls, *other);
  }
  return out;
}

std::string asked_text(const Figure& figure) {
  std::string text;
  if (figure.at_most_us > 0) text = "<= " + number_text(figure.at_most_us) + " us";
  if (figure.at_least_ratio > 0)
    text += (text.empty() ? ">= " : ", >= ") + number_text(figure.at_least_ratio) + " x";
  return text.empty() ? "-" : text;
}

/// A ratio that could not be measured is not met.
bool met(const Figure& figure, const Pool& pool) {
  if (figure.at_most_us > 0 && pool.median_us() > figure.at_most_us) return false;
  return figure.at_least_ratio <= 0 || pool.ratio().value_or(0) >= figure.at_least_ratio;
}

std::vector<Cell> figure_row(const Figure& figure, const Pools& pools) {
  Pool all;
  std::string slowest, least;
  std::int64_t meeting = 0;
  for (const auto& [pair, pool] : pools) {
    all.add(pool);
    meeting += met(figure, pool);
    if (slowest.empty() || pool.median_us() > pools.at(slowest).median_us()) slowest = pair;
    if (pool.ratio() && (least.empty() || pool.ratio() < pools.at(least).ratio())) least = pair;
  }
  const Statistics all_ours = summarize(all.ours_all);
  const bool asks = figure.at_most_us > 0 || figure.at_least_ratio > 0;
  return {figure.name,
          asked_text(figure),
          all_ours.median_us,
          all_ours.p99_us,
          slowest,
          pools.at(slowest).median_us(),
          figure.against.empty() ? "-" : figure.against,
          all.theirs.empty() ? Cell{} : Cell{median(times_of_poses(all.theirs))},
          cell(all.ratio()),
          least.empty() ? "-" : least,
          least.empty() ? Cell{} : cell(pools.at(least).ratio()),
          asks ? std::to_string(meeting) + " of " + std::to_string(pools.size()) : "-",
          all.theirs.empty() ? "-"
                             : std::to_string(all.missed) + " of " + std::to_string(all.compared)};
}

}  // namespace

std::vector<Figure> figures() {
  return {
      {"touch, far apart", "touch", {"far"}, "FCL", 0, 1},
      {"touch, overlapping", "touch", {"shallow", "deep"}, "FCL", 2, 3},
      {"touch, close but apart", "touch", {"near-5%", "near-1%", "touching"}, "FCL", 0, 3},
      {"touch, overlapping", "touch", {"shallow", "deep"}, "Bullet", 0, 0},
      {"touch, overlapping", "touch", {"shallow", "deep"}, "Sonde by its face", 0, 0},
      {"distance, cold", "distance", {"near-5%", "near-1%", "touching"}, "FCL", 50, 5},
      {"distance, cold", "distance", {"near-5%", "near-1%", "touching"}, "Sonde by its face", 0, 0},
      {"distance, warm", "distance-warm", {"trajectory"}, "Sonde cold", 15, 0},
      {"distance, warm", "distance-warm", {"trajectory"}, "FCL", 0, 0},
      {"near pairs within 2 % of R", "near-pairs", {"near-1%", "trajectory"}, "", 0, 0},
      {"sweep, long, with a turn", "sweep", {"trip"}, "FCL", 100, 1000},
      {"sweep, long, with a turn", "sweep", {"trip"}, "FCL oriented", 0, 0},
  };
}

std::optional<double> ratio_of(const std::vector<Result>& results, const Figure& figure) {
  Pool all;
  for (const auto& [pair, pool] : pools_of(results, figure)) all.add(pool);
  return all.ratio();
}

Table figures_table(const std::vector<Result>& results, const std::vector<Figure>& figures) {
  Table out;
  out.columns = {{"figure", ""},
                 {"asked", ""},
                 {"Sonde median", "us"},
                 {"Sonde p99", "us"},
                 {"slowest pair", ""},
                 {"slowest median", "us"},
                 {"against", ""},
                 {"their median", "us"},
                 {"ratio", ""},
                 {"least ratio at", ""},
                 {"least ratio", ""},
                 {"pairs that meet it", ""},
                 {"their wrong answers", ""}};
  for (const Figure& figure : figures) {
    const Pools pools = pools_of(results, figure);
    if (!pools.empty()) out.rows.push_back(figure_row(figure, pools));
  }
  return out;
}

}  // namespace sonde::bench
