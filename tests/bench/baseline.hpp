// SPDX-License-Identifier: GPL-3.0-or-later
// How fast Sonde was beside the other libraries when a baseline was written: ratios of times of one
// run, which another machine changes little.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/figures.hpp"
#include "tests/bench/result.hpp"

namespace sonde::bench {

/// Their median / ours, by the figure and the library: "distance, cold / FCL".
using Ratios = std::map<std::string, double>;

/// Of the figures that are measured against another library. Sonde against itself is left out.
Ratios ratios_of(const std::vector<Result>& results, const std::vector<Figure>& figures);

/// How much of a ratio has to be left. Two runs of --quick, one of them beside three builds,
/// differed by up to 28 %. With SSE2 instead of AVX2 0.48 and 0.71 of it are left of sweeps, 0.57
/// and 0.71 of distances.
constexpr double share_kept = 0.6;

/// A sentence for each ratio that is less than that share of its baseline, and for each of the
/// baseline that was not measured.
std::vector<std::string> slower_than(const Ratios& baseline, const Ratios& now);

/// The baseline of an instruction set out of the text of a file: {"avx2": {"touch, ...": 3.6}}; of
/// the next narrower one where there is none for that set. Throws InputError where there is none at
/// all, or where the text is not such JSON.
Ratios baseline_for(std::string_view instruction_set, const std::string& text);

/// The text with the ratios of that instruction set exchanged; an empty text holds none.
std::string with_baseline(std::string_view instruction_set, const Ratios& ratios,
                          const std::string& text);

}  // namespace sonde::bench
