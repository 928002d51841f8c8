// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/base/progress.hpp"
#include "engine/body/body.hpp"

namespace sonde {

/// The part of a body that another is near to, cut finely enough to be coloured by how near.
struct GapField {
  Soup patch;                ///< in the body's mesh frame
  std::vector<double> gaps;  ///< of the patch's vertices, m from the other's triangles
};

struct GapOptions {
  double reach = 0;           ///< m; what is further from the other body is left out
  double cell = 0;            ///< m; edges of the patch are no longer, while there is room
  std::size_t most = 60'000;  ///< triangles of the patch: beyond, it is cut no finer
};

/// X_OM is the pose of the body's mesh frame in the other's. Empty where `stop` says so meanwhile.
GapField gap_field(const Body& body, const Body& other, const Pose& X_OM, const GapOptions& options,
                   const Stop& stop = {});

}  // namespace sonde
