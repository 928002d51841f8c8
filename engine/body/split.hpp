// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace sonde {

/// A triangle while a tree is built: its axis-aligned box, in a unit that makes the whole body of
/// the order of 1 (it only affects how to split, not what a box contains).
struct SplitItem {
  float low[3];
  std::uint32_t triangle;
  float high[3];
  float unused = 0;
};

/// The box around all items: its low and its high corner.
std::pair<Eigen::Vector3f, Eigen::Vector3f> bounds(std::span<const SplitItem> items);
/// Half the surface of the box around all items.
double half_area(std::span<const SplitItem> items);

/// How to split a range.
enum class SplitBy {
  cost,  ///< the surface-area heuristic in 16 bins (after Wald, 2007)
  half   ///< by count, along the longest axis: terminates for any items
};

/// Reorders the items and returns how many go to the left: at least one, not all. Ranges of up to
/// 512 are cut at a multiple of `whole`, so that the last nodes are full.
std::size_t split(std::span<SplitItem> items, SplitBy by, std::size_t whole);

}  // namespace sonde
