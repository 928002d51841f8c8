// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>

#include "engine/body/body.hpp"
#include "tests/reference/depths_file.hpp"

namespace sonde::reference {

/// Writes a pair for `sonde query` into a folder: PAIR.probe.off, PAIR.fixed.off, and PAIR.csv with
/// the poses of its rows. Each number is read back as it was.
void write_pair(const std::filesystem::path& folder, const Body& probe, const Body& fixed,
                std::span<const Row> rows);

}  // namespace sonde::reference
