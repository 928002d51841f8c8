// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde::reference {

/// Two results are the same one where they differ by no more than this.
constexpr double repeats_to = 0.003;

/// One row of depths.csv: a pose and what the brute-force search found there. Lengths in metres.
struct Row {
  std::string pair = {};
  int index = 0;  ///< of the case within the pair
  std::string kind = {};
  std::size_t triangles_a = 0, triangles_b = 0;
  Pose pose = {};                 ///< X_FM, overlapping
  int starts = 0;                 ///< random starts of each seed
  std::array<double, 3> seeds{};  ///< the best depth of each seed
  double best = 0;                ///< the least of them, or what has been found since
  int hits = 0;    ///< of the random starts of all seeds, those that came within 1 % of the best
  double pdt = 0;  ///< the least translational depth
  Pose separated = {};  ///< X_FM, free, that the best belongs to
};

/// At least two seeds, each on its own, came to the best.
bool agreed(const Row& row);

/// "eight-eight/9 linked".
std::string name(const Row& row);

std::string header();
/// A line with 17 significant digits, and its end.
std::string to_line(const Row& row);

/// Empty where the file is not there. Throws InputError, naming file and line, on anything but
/// whole rows.
std::vector<Row> read_rows(const std::filesystem::path& file);
void write_rows(const std::filesystem::path& file, const std::vector<Row>& rows);

}  // namespace sonde::reference
