// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "engine/penetration/search/local_optima.hpp"
#include "engine/penetration/search/sketch_search.hpp"

namespace sonde {

/// Whether what a search has found so far is thought to be the best there is: by how many
/// independent starts agree on it, and by what the sketches show. It looks at the search's own
/// results, as they are when it is asked.
class Evidence {
 public:
  struct Rules {
    int agreement = 12;       ///< starts that are enough, whatever sketches show
    bool by_sketches = true;  ///< whether sketches may be enough (StaticOptions::by_evidence)
    const SearchTuning& tuned = search_tuning;
  };
  /// `sketched`: empty where the pair has no sketches.
  Evidence(const Chart& chart, const Rules& rules, const LocalOptima& optima,
           SketchSearch& sketches, std::span<SketchDescent> sketched)
      : chart_(chart), rules_(rules), optima_(optima), sketches_(sketches), sketched_(sketched) {}

  /// What has been found is thought to be the best there is.
  bool settles() const;
  /// What the bodies have come to is about what sketches say.
  bool sketches_see() const;
  /// The way out that was found is much longer than what overlaps: there may be a shorter one, too
  /// narrow for sketches to show. There must be sketches.
  bool may_be_narrow() const;
  /// The same, whatever agrees: starts that agree show that a way out is wide, not that none is
  /// shorter and narrow. False where there are no sketches, or no point of theirs lies deep.
  bool may_be_deep() const { return !optima_.empty() && is_far_out(optima_.best()); }
  /// That of a way out of such a length, m (Separation::far_out).
  bool is_far_out(double depth) const;
  /// By which depths on sketches may be wrong, m. There must be sketches.
  double sketch_error() const { return rules_.tuned.sketch_error * sketched_[0].spacing(); }

 private:
  int agreeing() const;
  bool sketches_are_clear() const;

  const Chart& chart_;
  Rules rules_;
  const LocalOptima& optima_;
  SketchSearch& sketches_;
  std::span<SketchDescent> sketched_;
};

}  // namespace sonde
