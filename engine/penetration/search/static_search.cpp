// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/static_search.hpp"

#include <algorithm>
#include <cstdint>

#include "engine/base/phase_timer.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/clearance_of.hpp"
#include "engine/penetration/search/search.hpp"
#include "engine/penetration/search/search_tuning.hpp"
#include "engine/penetration/search/touching.hpp"
#include "engine/penetration/search/translated_both_ways.hpp"
#include "engine/penetration/search/trivial_separation.hpp"

namespace sonde {
namespace {

/// The result of a search, and about the work it took (rather less than more), in the bound's
/// units.
struct Searched {
  Separation found;
  std::int64_t work;
};
Searched searched(const Pair& pair, const Pose& device, const StaticOptions& options,
                  const SearchTuning& tuning, const Deadline& deadline, const Progress& progress) {
  const auto with_work = [&](const Separation& found, int sketches) {
    return Searched{found, std::int64_t{tuning.bound_for_a_sketch} * sketches +
                               std::int64_t{tuning.bound_for_a_step} * found.iterations};
  };
  const bool limited = options.budget.microseconds > 0 || options.budget.steps > 0;
  if (options.method == Method::pdt && !limited) {
    const Translated both = translated_both_ways(pair, device, options, tuning, progress);
    return with_work(both.found, both.sketches);
  }
  Search search(pair, device, options, tuning, deadline, progress);
  const Separation found = search.run();
  return with_work(found, search.sketches_made());
}

/// A search consists of several in sequence, each of which reports progress from 0; this keeps the
/// reported fraction from falling.
Progress never_falling(const Progress& progress) {
  if (!progress) return {};
  return [&progress, most = 0.0](double fraction) mutable {
    most = std::max(most, fraction);
    return progress(most);
  };
}

}  // namespace

Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                           const SearchTuning& tuning, const Progress& progress) {
  const Deadline deadline{options.budget.microseconds, now_us()};
  const Pose device = is_finite(X_FM) ? Pose{X_FM.q.normalized(), X_FM.p} : X_FM;
  if (auto trivial = trivial_separation(pair.probe(), pair.fixed(), device)) {
    if (options.want_clearance && trivial->status == Status::separated)
      trivial->clearance = clearance_of(pair.probe(), pair.fixed(), device, false);
    return *trivial;
  }
  if (auto touching = touching_separation(pair.probe(), pair.fixed(), device, options.method)) {
    if (options.want_lower_bound && (pair.probe().solid || pair.fixed().solid))
      touching->lower_bound = 0;
    return *touching;
  }
  const double kept = options.want_lower_bound ? std::clamp(options.share_for_bound, 0.0, 1.0) : 0;
  auto [out, work] =
      searched(pair, device, options, tuning, deadline.part(1 - kept), never_falling(progress));
  const bool in_time = options.whole_bound || options.share_for_bound > 0 ||
                       !deadline.passed(tuning.least_us_for_bound);
  if (options.want_lower_bound && in_time && out.status == Status::penetrating) {
    const PhaseTimer timer(options.time_phases ? &out.phases : nullptr, Phase::bound);
    BoundOptions bound{.translations = options.method == Method::pdt, .known = out.depth};
    if (!options.whole_bound)
      bound.work = static_cast<int>(std::min<std::int64_t>(bound.work, work));
    out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), device, deadline, bound);
  }
  return out;
}

Separation separate_static(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                           const Progress& progress) {
  return separate_static(pair, X_FM, options, search_tuning, progress);
}

}  // namespace sonde
