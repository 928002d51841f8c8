// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/body/body.hpp"

namespace sonde {

/// The part of a body that is near another body, cut finely enough to colour it by the gap.
struct GapField {
  Soup patch;  ///< in the body's mesh frame
  std::vector<double>
      gaps;  ///< gap at each vertex of the patch: distance from the other's triangles, m
};

struct GapOptions {
  double reach = 0;           ///< m; parts further from the other body are left out
  double cell = 0;            ///< m; largest edge of the patch, while there is room
  std::size_t most = 60'000;  ///< limit of the triangles of the patch; may leave edges longer
};

/// X_OM is the pose of the body's mesh frame in the other's. Empty if `stop` returns true
/// meanwhile.
GapField gap_field(const Body& body, const Body& other, const Pose& X_OM, const GapOptions& options,
                   const Stop& stop = {});

}  // namespace sonde
