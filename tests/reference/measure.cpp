// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/measure.hpp"

#include <algorithm>
#include <limits>

#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/platform/processor_time.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde::reference {

double Measured::excess() const {
  if (got.status != Status::penetrating) return std::numeric_limits<double>::infinity();
  return got.depth / reference - 1;
}

Measured measure(const Row& row, const Pair& pair, const StaticOptions& options,
                 const SearchTuning& tuning) {
  Measured out;
  out.row = row;
  out.reference = options.method == Method::pdg ? row.best : row.pdt;
  StaticOptions search = options;
  search.want_lower_bound = false;
  // A budget of time is kept by the wall's clock, and two threads share what one would take.
  const bool wall = search.budget.microseconds > 0 || search.two_threads;
  const auto now = [&] { return wall ? now_us() : processor_time_us(); };
  const double started = now();
  out.got = separate_static(pair, row.pose, search, tuning);
  const double searched = now();
  out.time_us = searched - started;
  if (options.whole_bound) {
    out.lower_bound =
        depth_lower_bound(pair.probe(), pair.fixed(), row.pose, {},
                          {.translations = options.method == Method::pdt, .known = out.got.depth});
    out.bound_us = now() - searched;
  } else {
    search.want_lower_bound = true;
    out.lower_bound = separate_static(pair, row.pose, search, tuning).lower_bound;
    out.bound_us = std::max(0.0, now() - searched - out.time_us);
  }
  out.free = out.got.status != Status::failed &&
             !overlap(pair.probe(), pair.fixed(), Transform(out.got.separated), Doubt::exact);
  return out;
}

bool mend(Row& row, const Measured& by, Method method) {
  if (!by.free || !(by.got.depth < by.reference)) return false;
  if (method == Method::pdt) row.pdt = by.got.depth;
  // A translation is an answer for six unknowns as well.
  if (by.got.depth < row.best) {
    row.best = by.got.depth;
    row.separated = by.got.separated;
  }
  return true;
}

}  // namespace sonde::reference
