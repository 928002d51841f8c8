// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/progress.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/search/static_options.hpp"

namespace sonde {

/// A part of an assembly, at its place in the world.
struct AssemblyPart {
  std::string name;
  std::shared_ptr<const Body> body;
  Pose X_WM;
};

/// How two parts of an assembly stand to each other.
struct Clash {
  enum class Kind { overlapping, touching, clear, failed };
  std::array<std::size_t, 2> parts = {0, 0};  ///< of the list, the lower number first
  Kind kind = Kind::failed;
  /// m: where they overlap or touch by more than nothing, how deep, at the contacts themselves
  /// (`separated` keeps a clearance from them); none else.
  std::optional<double> depth, lower_bound;
  std::optional<double> clearance;  ///< m: where they are clear, their least distance
  /// Where they are nearest, or the middle of the contacts that hold the way out, world, m. None
  /// where a search found no contact.
  std::optional<Vec3> place;
  std::size_t moved = 0;          ///< which of the two the way out moves: the smaller one
  std::optional<Pose> separated;  ///< its pose X_WM out of the overlap
  const char* reason = "";        ///< why it failed
};
/// "overlapping", "touching", "clear" or "failed".
const char* name_of(Clash::Kind kind);

struct ClashOptions {
  /// m: overlaps up to this deep count as touching, and so do gaps up to this; what is less than
  /// the rounding of coordinates always does.
  double allowance = 0;
  /// m: pairs that are clear by more than this are left out.
  double within = 0;
  /// Of the searches; a pair's own seed comes from this and its poses.
  StaticOptions search = {};
  unsigned threads = 1;
};

/// All pairs of parts that are nearer than asked, the deepest first, then those that touch, then
/// those that are clear, the nearest first. The same bits on any number of threads. Throws
/// Cancelled.
std::vector<Clash> clashes(const std::vector<AssemblyPart>& parts, const ClashOptions& options,
                           const Progress& progress = {});

}  // namespace sonde
