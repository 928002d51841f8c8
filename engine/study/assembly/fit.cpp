// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/fit.hpp"

#include <cmath>

#include "engine/base/error.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/proximity/queries/placement.hpp"

namespace sonde {
namespace {

/// In rounding errors of placing the parts: how much more than the allowance the faces are moved.
/// An overlap of just the allowance is then free by more than moving and placing them loses.
constexpr double more_in_roundings = 4;

/// The next power of two, so that parts that are many times in an assembly are taken smaller by few
/// different lengths. It adds at most as much again.
double rounded_up(double rounding) { return std::ldexp(1.0, std::ilogb(rounding) + 1); }

}  // namespace

const Body* Fits::smaller(const Body& body, double by) {
  Smaller* entry = nullptr;
  {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Smaller>& known = known_[{&body, by}];
    if (!known) known = std::make_unique<Smaller>();
    entry = known.get();
  }
  std::call_once(entry->made, [&] {
    if (!body.solid || !body.loose.empty()) return;
    try {
      entry->body = offset_faces(body, -by);
    } catch (const InputError&) {  // too thin
    }
  });
  return entry->body.get();
}

Fits::Answer Fits::ask(const Body& probe, const Body& fixed, const Pose& X_FM, double allowance) {
  const double rounding = rounding_guard(extent(probe), extent(fixed), X_FM.p);
  const double by = allowance + more_in_roundings * rounded_up(rounding);
  const Body* const small_probe = smaller(probe, by);
  if (small_probe && !test_free(*small_probe, fixed, X_FM).free) return Answer::overlap;
  const Body* const small_fixed = smaller(fixed, by);
  if (small_fixed && !test_free(probe, *small_fixed, X_FM).free) return Answer::overlap;
  return small_probe || small_fixed ? Answer::fit : Answer::unknown;
}

}  // namespace sonde
