// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/measure.hpp"

#include <limits>

#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/descent/descent.hpp"
#include "engine/proximity/queries/intersect.hpp"

namespace sonde::reference {

double Measured::excess() const {
  if (got.status != Status::penetrating) return std::numeric_limits<double>::infinity();
  return got.depth / reference - 1;
}

Measured measure(const Row& row, const Pair& pair, const StaticOptions& options) {
  Measured out;
  out.row = row;
  out.reference = options.method == Method::pdg ? row.best : row.pdt;
  StaticOptions search = options;
  search.want_lower_bound = false;
  const double started = now_us();
  out.got = separate_static(pair, row.pose, search);
  const double searched = now_us();
  out.lower_bound = depth_lower_bound(pair.probe(), pair.fixed(), row.pose);
  out.bound_us = now_us() - searched;
  out.time_us = searched - started;
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
