// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// Reads a model by assimp, as its importer of that extension does, times `scale`: in a process of
/// its own, which a bad file may end. Nothing else is opened. `corners`: of the faces and lines of
/// all copies. Throws InputError where assimp refuses, ends, or makes others of it, nothing is in
/// the file, or Sonde was built without it.
PolygonSoup import_model(const std::string& file, std::string_view bytes, const char* extension,
                         double scale, std::uint64_t corners, const Progress& progress);

}  // namespace sonde
