// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/study/comparison/compare.hpp"

namespace sonde::test {

/// A pair of bodies with a device path, as the table of resources/docs/use/compare.md has it.
struct ComparedPair {
  std::string name;
  std::function<CompareSetup()> setup;
};

/// The bundled scenes with their own paths, then pairs of real meshes (libcgal-demo) and of shapes
/// on a large box, with paths made here from a seed: in from a random side, a third of the probe's
/// radius past the first contact, along and round there, and out again; 1 kHz, slowly enough for a
/// hand.
std::vector<ComparedPair> compared_pairs();

/// All parts computed here, and what they come to.
Comparison compare_pair(const ComparedPair& pair);

/// The table: its two first lines, and the line of one pair.
std::string table_head();
std::string table_row(const std::string& name, const Comparison& comparison);

}  // namespace sonde::test
