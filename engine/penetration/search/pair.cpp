// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pair.hpp"

#include <utility>

#include "engine/base/round_to_nearest.hpp"
#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {
namespace {

std::shared_ptr<const Body> given(std::shared_ptr<const Body> body) {
  if (!body) throw InputError("a pair needs two bodies");
  return body;
}

std::shared_ptr<const Sketches> sketches_of(const Body& probe, const Body& fixed,
                                            const Progress& progress) {
  const RoundToNearest round_to_nearest;
  return std::make_shared<const Sketches>(make_sketches(probe, fixed, progress));
}

}  // namespace

Pair::Pair(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed,
           const Progress& progress)
    : probe_(given(std::move(probe))),
      fixed_(given(std::move(fixed))),
      sketches_(sketches_of(*probe_, *fixed_, progress)) {}

Pair::Pair(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed,
           std::shared_ptr<const Sketches> sketches) noexcept
    : probe_(std::move(probe)), fixed_(std::move(fixed)), sketches_(std::move(sketches)) {}

Pair Pair::exchanged() const {
  return {fixed_, probe_,
          std::make_shared<const Sketches>(Sketches{sketches_->fixed, sketches_->probe})};
}

}  // namespace sonde
