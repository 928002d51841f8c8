// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

#include "engine/base/error.hpp"

namespace sonde {

/// Asked now and then by long work that knows no fraction: true where it is to stop (most of it
/// then throws Cancelled).
using Stop = std::function<bool()>;

/// Tells progress, where there is any; throws Cancelled where it says so.
void report(const Progress& progress, double fraction);

/// The part of a progress from one fraction to another. It refers to the whole, and must not
/// outlive it.
Progress part_of(const Progress& progress, double from, double to);

/// Does step(i) for 0 ≤ i < n, and reports before each piece: one of this size takes milliseconds.
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
