// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/mending/parts.hpp"
#include "engine/mending/point_windings.hpp"
#include "engine/mending/sealed.hpp"

namespace sonde {

/// Which parts lie inside which others, by sample points. A part some of whose faces lie on
/// another's (a pocket, a hole drilled through) is judged by points below its faces.
class Nesting {
 public:
  /// Of the facts, only the volumes count, and what is there both ways round. Throws Cancelled.
  Nesting(const Sealed& sealed, const std::vector<PartFacts>& facts, const Progress& progress);

  /// Parts that have a sample point of this one inside.
  const std::set<std::uint32_t>& around(std::uint32_t p) const { return around_[p]; }
  /// Whether all of part p lies inside part q.
  bool is_in(std::uint32_t p, std::uint32_t q) const;
  /// Whether all of its surface lies inside others, of which there are several.
  bool has_faces_in_several(std::uint32_t p) const;
  /// The same, but some of its faces may lie on theirs.
  bool is_in_several(std::uint32_t p) const;
  /// Whether it is nested in no part, leaving out `but`.
  bool is_outermost(std::uint32_t q, std::uint32_t but) const;

 private:
  /// Sample points of a part: how many lie inside which others, and inside any other.
  struct Samples {
    std::size_t all = 0;
    std::size_t covered = 0;
    std::map<std::uint32_t, std::size_t> inside;

    bool all_inside(std::uint32_t q) const;
    bool all_covered() const { return all > 0 && covered == all; }
  };

  static std::vector<Samples> samples_of(const std::vector<PartPoint>& points,
                                         const std::vector<PartWindings>& around,
                                         std::size_t parts);
  void find_filled(const std::vector<PartPoint>& below, const std::vector<PartWindings>& around,
                   const std::vector<PartFacts>& facts);

  std::vector<Eigen::AlignedBox3d> bounds_;
  std::vector<bool> filled_;                     // by part
  std::vector<Samples> on_faces_, below_;        // by part
  std::vector<std::set<std::uint32_t>> around_;  // by part
};

/// Which parts must be turned inside out: an outermost part with negative volume, together with
/// everything nested in it. So a cavity stays a cavity, and a mirrored half counts as the other
/// half does. A part is nested in another if all sample points on it lie inside that one, or, since
/// its faces may lie on the other's, all points just below its faces do; and in several together if
/// each point lies inside one of them. A part that is there both ways round is a body where its
/// faces lie on those of one that is not. Two parts in the same place are not nested. `sealed`
/// contains only parts that bound an inside (`solid`, by part). Throws Cancelled.
std::vector<bool> parts_to_turn(const Sealed& sealed, const std::vector<PartFacts>& facts,
                                const std::vector<bool>& solid, const Progress& progress = {});

}  // namespace sonde
