// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "engine/base/error.hpp"
#include "engine/penetration/search/pair.hpp"

namespace sonde {

/// Writes what a pair computes once for both bodies (not the bodies themselves) to a file of 0.4 to
/// 1.1 MB, for programs that start often with the same large bodies. The file is written whole or
/// not at all.
/// @throws InputError, naming the file and the reason, if it cannot be written.
void write_pair(const std::filesystem::path& file, const Pair& pair);

/// The pair of these bodies with the contents of the file: the same bits as a new pair.
/// @throws InputError, naming the file and the reason, if it is missing, is not a pair file, is
/// damaged or from another version of Sonde, or was written for other bodies (other triangles,
/// model or mass properties), and if a body is missing.
Pair read_pair(const std::filesystem::path& file, std::shared_ptr<const Body> probe,
               std::shared_ptr<const Body> fixed);

}  // namespace sonde
