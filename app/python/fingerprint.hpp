// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "engine/sonde.hpp"

namespace sonde::python {

/// A number for all of a body that depths and wrenches depend on: the same for what is made again
/// of the same, in this process or another.
std::uint64_t fingerprint(const sonde::Body& body, const BodyFacts& known);

/// Which pair a result is of.
struct PairMark {
  std::uint64_t probe = 0, fixed = 0;  ///< the bodies' fingerprints
  bool operator==(const PairMark&) const = default;
};

}  // namespace sonde::python
