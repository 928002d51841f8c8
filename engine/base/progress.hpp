// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "engine/base/error.hpp"

namespace sonde {

/// Called from time to time by long work without a known fraction; returns true to stop it (most of
/// this work then throws Cancelled).
using Stop = std::function<bool()>;

/// Calls `progress`, if there is any; throws Cancelled if it returns false.
void report(const Progress& progress, double fraction);

/// Maps a progress to the range between two fractions of the whole. It refers to the whole, and
/// must not outlive it.
Progress part_of(const Progress& progress, double from, double to);

/// Calls step(i) for 0 ≤ i < n, and reports before each piece; a piece takes milliseconds.
template <class Step>
void for_each_index(std::size_t n, const Progress& progress, Step step) {
  constexpr std::size_t piece = 1 << 16;
  for (std::size_t at = 0; at < n; at += piece) {
    report(progress, static_cast<double>(at) / static_cast<double>(n));
    const std::size_t end = std::min(n, at + piece);
    for (std::size_t i = at; i < end; ++i) step(i);
  }
}

}  // namespace sonde
