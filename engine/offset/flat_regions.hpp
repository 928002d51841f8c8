// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/soup.hpp"
#include "engine/offset/fans.hpp"

namespace sonde {

/// The flat parts of a surface: a flat face is its outline, however it is cut into triangles.
class FlatRegions {
 public:
  /// Triangles that hang together at sides and whose normals (of unit length) are within their
  /// tilts (rad) of that of one of them. Those that have no say join any neighbour.
  FlatRegions(const Fans& fans, const std::vector<Vec3>& normals, const std::vector<char>& has_say,
              const std::vector<double>& tilts);

  std::uint32_t of(std::uint32_t triangle) const { return of_[triangle]; }
  /// The triangle on the other side of a side of a triangle; none where there is not just one.
  std::optional<std::uint32_t> across(std::uint32_t triangle, std::size_t side) const;
  std::span<const std::uint32_t> triangles(std::uint32_t region) const {
    return {triangles_.data() + first_[region], first_[region + 1] - first_[region]};
  }

 private:
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<std::uint32_t> of_, triangles_, first_;
};

/// A side of a triangle, by fans.
using FanSide = std::array<std::uint32_t, 2>;

/// The sides of some triangles that none of them has the other way round.
std::vector<FanSide> outline_of(const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Triangles within an outline of places, as seen against the normal, that have no corner but its;
/// none where it crosses itself or is the wrong way round.
std::optional<std::vector<std::array<std::uint32_t, 3>>> filled(const std::vector<FanSide>& outline,
                                                                const std::vector<Vec3>& places,
                                                                const Vec3& normal);

}  // namespace sonde
