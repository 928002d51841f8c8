// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/reference_row.hpp"

#include <algorithm>
#include <limits>

namespace sonde::reference {
namespace {

/// Takes over what is better than the best of the row.
void keep_better(Row& row, const BruteResult& found) {
  if (!(found.depth < row.best)) return;
  row.best = found.depth;
  row.separated = found.separated;
}

}  // namespace

Reference reference_row(const PairSpec& spec, const Body& probe, const Body& fixed, const Case& at,
                        int starts) {
  Reference out;
  out.row = {.pair = spec.name,
             .index = at.index,
             .kind = name(at.kind),
             .triangles_a = probe.soup.triangles.size(),
             .triangles_b = fixed.soup.triangles.size(),
             .pose = at.pose,
             .starts = starts};
  Row& row = out.row;
  row.best = row.pdt = std::numeric_limits<double>::infinity();
  std::vector<double> reached;
  for (std::size_t s = 0; s < row.seeds.size(); ++s) {
    BruteOptions options;
    options.starts = starts;
    options.hops = starts / 4;
    options.seed = s + 1;
    const BruteResult found = brute_search(probe, fixed, at.pose, options);
    row.seeds[s] = found.depth;
    out.origins[s] = found.origin;
    keep_better(row, found);
    reached.insert(reached.end(), found.reached.begin(), found.reached.end());
    // Three unknowns want fewer starts. What they find is an answer for six as well.
    options.method = Method::pdt;
    options.starts = starts / 4;
    options.hops = 0;
    const BruteResult shifted = brute_search(probe, fixed, at.pose, options);
    row.pdt = std::min(row.pdt, shifted.depth);
    keep_better(row, shifted);
  }
  row.hits = static_cast<int>(std::count_if(reached.begin(), reached.end(),
                                            [&](double d) { return d <= 1.01 * row.best; }));
  return out;
}

}  // namespace sonde::reference
