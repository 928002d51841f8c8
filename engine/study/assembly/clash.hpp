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

/// The relation of two parts of an assembly.
struct Clash {
  enum class Kind { overlapping, touching, clear, failed };
  std::array<std::size_t, 2> parts = {0, 0};  ///< indices in the list, the lower one first
  Kind kind = Kind::failed;
  /// m: if the parts overlap, or touch by more than nothing: their depth, at the contacts
  /// themselves (`separated` keeps a clearance from them); otherwise none.
  std::optional<double> depth, lower_bound;
  std::optional<double> clearance;  ///< m: least distance, if they are clear of each other
  /// The closest point, the centroid of the contacts that hold the way out, or the middle of where
  /// they touch; world frame, m.
  std::optional<Vec3> place;
  std::size_t moved = 0;          ///< which of the two is moved by the way out: the smaller one
  std::optional<Pose> separated;  ///< its pose X_WM out of the overlap
  /// They touch, but are held: they overlap nowhere by more than the allowance (Fits), and `depth`,
  /// which is more, is the way out of the fit.
  bool fit = false;
  /// Why it failed; if they overlap, why that was not compared with the allowance. Otherwise empty.
  const char* reason = "";
};
/// "overlapping", "touching", "clear" or "failed".
const char* name_of(Clash::Kind kind);

struct ClashOptions {
  /// m: overlaps that are nowhere deeper, and gaps up to this width, count as touching. Values
  /// below the rounding of coordinates always do.
  double allowance = 0;
  /// m: pairs with a larger clearance are left out.
  double within = 0;
  /// Options of the searches. A pair's own seed is made from the seed here and its poses.
  StaticOptions search = {};
  unsigned threads = 1;
};

/// All pairs of parts that are nearer than requested: the deepest first, then those that touch,
/// then those that are clear, the nearest first. The same bits on any number of threads. Throws
/// Cancelled.
std::vector<Clash> clashes(const std::vector<AssemblyPart>& parts, const ClashOptions& options,
                           const Progress& progress = {});

}  // namespace sonde
