// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Reads a model by assimp, as its importer of that extension does, times `scale`. Nothing else is
/// opened. `bytes` have been checked; `faces`: of all copies, where that is known. Throws
/// InputError where assimp refuses or drops faces, nothing is in it, or Sonde was built without it.
PolygonSoup import_model(const std::string& file, std::string_view bytes, const char* extension,
                         double scale, std::optional<std::uint64_t> faces,
                         const Progress& progress);

}  // namespace sonde
