// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/soup.hpp"

namespace sonde {

/// A soup, or why there is none, as bytes for another process of this machine.
std::string packed(const PolygonSoup& soup);
std::string packed(const InputError& error);

/// The same soup; throws the same error. What does not fit together, because the process that
/// packed it went wrong, is an InputError too.
PolygonSoup unpacked(const std::string& file, std::string_view bytes);

}  // namespace sonde
