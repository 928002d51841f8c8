// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde::python {

/// Which pair a result is of.
struct PairMark {
  std::uint64_t probe = 0, fixed = 0;  ///< the bodies' fingerprints
  bool operator==(const PairMark&) const = default;
};

}  // namespace sonde::python
