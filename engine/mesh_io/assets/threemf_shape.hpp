// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {

/// A 3MF file with nothing in it but its model.
struct ThreeMfShape {
  std::string bytes;
  double metres = 1e-3;         ///< its unit
  std::uint64_t triangles = 0;  ///< of all copies
  std::vector<std::string> remarks;
};

/// Checks the package and its model (3MF Core Specification 1.3), and packs the model again: a
/// library may end the program over a damaged package. Throws InputError as asset_readers.hpp has
/// it.
ThreeMfShape threemf_shape(const std::string& file, std::string_view bytes,
                           const Progress& progress);

}  // namespace sonde
