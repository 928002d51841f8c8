// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {

/// What is asked of a COLLADA file before a library reads it.
struct DaeShape {
  double metres = 1;          ///< its unit
  std::uint64_t corners = 0;  ///< of the faces and lines of all copies
  std::vector<std::string> remarks;
};

/// Checks what places what (COLLADA 1.4 and 1.5). Throws InputError as asset_readers.hpp has it.
DaeShape dae_shape(const std::string& file, std::string_view bytes, const Progress& progress);

}  // namespace sonde
