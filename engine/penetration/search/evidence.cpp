// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/evidence.hpp"

namespace sonde {

/// Number of independent starts that ended at the best depth: starts on the bodies, and starts on
/// sketches from whose ends the bodies reached it.
int Evidence::agreeing() const {
  int out = optima_.agreeing();
  for (const SketchEnd& end : sketches_.ends())
    if (end.came_to >= 0 && optima_.is_best(end.came_to)) out += end.starts;
  return out;
}

bool Evidence::is_conclusive() const {
  if (optima_.empty()) return false;
  if (agreeing() >= rules_.agreement) return true;
  return rules_.by_sketches && sketches_see() && sketches_are_clear();
}

bool Evidence::sketches_are_clear() const {
  const SketchEnd& first = sketches_.ends().front();
  return sketches_.is_clear(rules_.tuned.clear) && first.came_to >= 0 &&
         optima_.is_best(first.came_to);
}

bool Evidence::sketches_see() const {
  if (descents_.empty() || sketches_.ends().empty()) return false;
  return optima_.best() <
         rules_.tuned.rough_error * sketches_.ends().front().depth + sketch_error();
}

bool Evidence::may_be_narrow() const {
  return !is_conclusive() || exceeds(optima_.best(), rules_.tuned.narrow_for_pushes);
}

bool Evidence::is_far_out(double depth) const { return exceeds(depth, rules_.tuned.narrow); }

bool Evidence::exceeds(double depth, double times) const {
  if (descents_.empty()) return false;
  const double deepest = descents_[0].depth_of_points(chart_, Vec6::Zero());
  return deepest > 0 && depth > times * deepest;
}

}  // namespace sonde
