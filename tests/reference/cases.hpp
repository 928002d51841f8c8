// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/body/body.hpp"

namespace sonde::reference {

/// How the bodies of a case lie: just in contact along a line from outside and a few hundredths of
/// the smaller one's radius further in; centres a good part of both radii apart; centres close; or
/// about a pose in which one is hooked into the other.
enum class Kind { shallow, medium, deep, linked };
constexpr std::size_t kinds = 4;
const char* name(Kind kind);

using MakeBody = std::function<std::shared_ptr<const Body>()>;

/// Two bodies and the number of poses of each kind. Bodies are made when they are asked for.
struct PairSpec {
  std::string name;
  MakeBody probe, fixed;
  std::array<int, kinds> count{};
  int starts = 400;  ///< random starts of the brute-force search, fewer where a descent is dear
  /// Linked only: the pose to begin with, and the turn (rad) and the shift (of the probe's R) that
  /// it is disturbed by, more and more until the bodies overlap.
  Pose linked = {};
  double turn = 0.35;
  double shift = 0.15;
};
/// The family of a pair, of shapes that are alike: scanned, engineered, tangled, nested, fits,
/// soups, thin. Claims are held against families that they were not fitted to.
std::string family_of(const std::string& pair);

struct Case {
  int index = 0;  ///< within the pair
  Kind kind = Kind::medium;
  Pose pose;  ///< X_FM, at which the bodies overlap
};

/// Those of depths.csv.
const std::vector<PairSpec>& pair_specs();
/// Those of deep_tuning.csv and deep_reporting.csv: families of deep concave pairs. The search was
/// tuned with shapes like the first ones in sight, and nothing was changed since it was measured on
/// the second ones.
const std::vector<PairSpec>& deep_tuning_specs();
const std::vector<PairSpec>& deep_reporting_specs();
/// All of them.
std::vector<const PairSpec*> known_specs();

/// The poses of a pair, always the same ones. Each overlaps by the exact test.
std::vector<Case> cases(const PairSpec& spec, const Body& probe, const Body& fixed);

/// How many poses a pair has.
int case_count(const PairSpec& spec);

}  // namespace sonde::reference
