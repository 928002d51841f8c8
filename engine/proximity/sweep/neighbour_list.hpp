// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/queries/near_pairs.hpp"
#include "engine/proximity/queries/placement.hpp"
#include "engine/proximity/queries/violation.hpp"
#include "engine/proximity/sweep/linearized_motion.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "engine/proximity/sweep/pair_sweep.hpp"
#include "engine/proximity/sweep/sweep.hpp"
#include "engine/proximity/triangles/pair_lanes.hpp"

namespace sonde {

/// The pairs of triangles that were within a reach of each other at one pose. As long as the probe
/// has moved by less than that reach, near() and sweep_along() examine only these pairs. So one
/// traversal of the trees serves many small steps (after the neighbour lists of L. Verlet, 1967).
///
/// How far a triangle of A has moved follows from the motion of one point of A, the centre, and
/// from the triangle's arm, its distance from that point. The best centre lies among the contacts:
/// triangles there hardly move while the probe rolls or turns, and those far from it are mostly far
/// from the fixed body too. Only the constructor allocates.
class NeighbourList {
 public:
  /// Capacity, in pairs, that suffices for two bodies whose surfaces fit into each other. Every
  /// triangle there has some thirteen of the other body near it, so if such surfaces are half of
  /// both bodies, there are some three facing pairs a triangle; a list for eight times the reach
  /// holds less than three times the pairs (a ball in its socket). At most 131 072 pairs, which
  /// take 19 MB (a solver has two lists): of larger surfaces that fit into each other there is no
  /// list, and each step traverses the trees. (Two wavy blocks of 6720 triangles each have some
  /// 42 000 facing pairs. Their longest tick took 106 ms without a list, and 11 ms with one.)
  static std::size_t enough(const Body& a, const Body& b);
  NeighbourList(const Body& a, const Body& b, std::size_t capacity);
  NeighbourList(const Body& a, const Body& b) : NeighbourList(a, b, enough(a, b)) {}

  /// What a list covers: every pair whose distance falls to around.of(arm) or less somewhere on the
  /// course `ahead`. The arm is that of the pair's triangle of A. A sliding probe mostly continues
  /// in the same direction. A list for its course holds fewer pairs than one for all directions,
  /// and stays valid as long.
  struct Coverage {
    DisplacementBound around;
    Course ahead = {};
  };
  /// The coverage that a build aims at. While it runs, the build changes from `wanted` to
  /// `fallback` if `wanted` takes more work than `most_work`, or has more pairs than fit. The pairs
  /// found by then are kept if they belong to the fallback.
  struct BuildPlan {
    Coverage wanted;
    Coverage fallback;  ///< its course is a part of that of `wanted`
    std::int64_t most_work = std::numeric_limits<std::int64_t>::max();
  };

  /// Lists every pair that the plan covers from X on. `centre` is in A's mesh frame. Returns false,
  /// and the list covers nothing, if even the fallback has more pairs than fit, or if the effort
  /// ran out. In the second case go_on() can finish the list later.
  bool build_by(const BuildPlan& plan, const Transform& X, const Vec3& centre,
                Effort& effort) noexcept;
  bool build(const Transform& X, const Vec3& centre, const DisplacementBound& room,
             Effort& effort) noexcept {
    return build_by({{room}, {room}}, X, centre, effort);
  }
  /// Lists every pair that may be within `reach` (m) of each other at X.
  bool build(const Transform& X, double reach, Effort& effort) noexcept {
    return build(X, a_.mass.com, {reach, 0}, effort);
  }

  /// Continues a build that ran out of effort. Returns as build_by does.
  bool go_on(Effort& effort) noexcept;
  bool is_unfinished() const noexcept { return unfinished_; }
  /// The value that reach_at() will return, for a path from X, when the build is finished.
  double reach_when_finished(const Transform& X, const LinearizedMotion& path) const noexcept {
    return planned_.around.linear < 0 ? -1 : left(planned_, X, path);
  }

  void clear() noexcept {
    count_ = 0, unfinished_ = false;
    coverage_.around.linear = planned_.around.linear = -1;
  }
  std::size_t size() const noexcept { return count_; }
  std::size_t capacity() const noexcept { return capacity_; }
  /// True if the last build covers the fallback of its plan and no more.
  bool used_fallback() const noexcept { return fallback_only_; }
  /// The work of the last build, in the units of Effort.
  std::int64_t work_of_build() const noexcept { return work_of_build_; }

  /// m: the list holds every pair that comes within this distance at X or on the path from there.
  /// Negative: the list says nothing about that path.
  double reach_at(const Transform& X, const LinearizedMotion& path = {}) const noexcept {
    return coverage_.around.linear < 0 ? -1 : left(coverage_, X, path);
  }
  /// True if the list holds every pair that may come within `clearance` (m) along the motion.
  bool covers(const Motion& motion, double clearance) const noexcept;

  /// As near_pairs() and sweep(), for the pairs of the list. `reach` must not exceed reach_at(X),
  /// and covers() must hold for the motion.
  NearPairs near(const Transform& X, double reach, std::span<NearPair> out,
                 Effort& effort) noexcept;
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

  /// Writes to `out` the pairs that are nearer than `least` (m) at X, or that meet there: the
  /// deepest, if there are more than fit. `least` must not exceed reach_at(X). X is a trial pose:
  /// the pose from which travel is counted does not change. Returns the number of pairs.
  std::size_t violations(const Transform& X, double least, std::span<Violation> out,
                         Effort& effort) noexcept;

 private:
  static constexpr std::size_t block = 8;  ///< pairs that are compared together
  struct Pair {
    std::uint32_t a, b;  ///< triangles
  };
  struct Pairs {
    std::uint32_t a[block], b[block];
  };
  /// A bound for the pairs of a block. `distance` (m) is the least distance last found, plus the
  /// travel until then; `arm` (m) is the longest arm. A turn brings a triangle nearer by up to its
  /// arm times the angle. A block is skipped as long as `distance` minus the travel exceeds the
  /// reach of the query (spare()).
  struct BlockBound {
    double distance, arm;
  };
  /// A pair that may stop a path: the direction that separated it last does not prove that it stays
  /// apart.
  struct UnprovenPair {
    std::uint32_t item;
    double until;  ///< about where the pair may stop the path, 0 to 1
  };
  /// m: the reach that a list of this coverage has on a path from X.
  double left(const Coverage& room, const Transform& X,
              const LinearizedMotion& path) const noexcept;
  /// m: what rounding may add to a distance at X or at the pose of the list.
  double guard(const Transform& X) const noexcept;
  /// Adds the displacement from the last pose to X to the accumulated travel of the probe.
  void travel_to(const Transform& X) noexcept;
  /// m: a lower bound of the distance of a block's pairs now.
  double spare(const BlockBound& d) const noexcept {
    return d.distance - linear_ - d.arm * turned_;
  }
  std::size_t blocks() const noexcept { return (count_ + block - 1) / block; }
  std::size_t size_of(std::size_t k) const noexcept { return std::min(block, count_ - k * block); }
  /// Calls visit(k) for each block k with a pair that may come within `within` (m) while the probe
  /// moves by `ahead`.
  template <class Visit>
  void each_due(const DisplacementBound& ahead, double within, const Visit& visit) const noexcept;
  struct Candidates;
  /// How a box of A moves on the planned course.
  struct BoxMotion {
    double arm = 0;             ///< m: the longest arm of the box's points
    Vec3 shift = Vec3::Zero();  ///< m: displacement of the box's centre, fixed frame
    double spread = 0;  ///< m: bound of the difference of any point's displacement from that
  };
  BoxMotion box_motion(std::uint32_t slot) const noexcept;
  /// True if the plan covers the pair. `due` holds its distance and arm, `normal` the direction
  /// that separates it (zero: none is known).
  bool is_in_plan(const Pair& pair, const BlockBound& due, const Vec3& normal) const noexcept;
  void start(const Transform& X, const Vec3& centre) noexcept;
  /// Appends the candidates that the plan covers.
  void append_covered(Candidates& of) noexcept;
  /// Changes to the plan's fallback, and drops the pairs that it does not cover.
  void fall_back() noexcept;
  /// Appends a pair with its distance, its arm and the direction that separates it at the pose of
  /// the list (zero: none).
  void append(const Pair& pair, const BlockBound& due, const Vec3& normal) noexcept;
  /// Fills the unused lanes of the last block with copies of its last pair.
  void fill_last() noexcept;
  Vec3 normal_of(std::uint32_t item) const noexcept;
  void set_normal(std::uint32_t item, const Vec3& normal) noexcept;
  /// Raises the bound of block k by the least gap (m) that was found in it at the present pose.
  void learn(std::size_t k, double gap, double rounding) noexcept;
  /// Decides how far the unproven pairs leave a path free: tries other separating directions, and
  /// if none suffices, advances the pair along the path up to its stop.
  void follow(std::span<const UnprovenPair> open, PairSweep& pairs, const DisplacementBound& ahead,
              Effort& effort) noexcept;

  const Body& a_;
  const Body& b_;
  std::vector<Pairs> items_;
  std::vector<PairLanes> lanes_;
  std::vector<BlockBound> block_bounds_;
  std::vector<BlockBound> pair_bounds_;  // of the list under construction
  std::vector<UnprovenPair> unproven_;
  std::size_t count_ = 0;
  std::size_t capacity_;
  std::int64_t work_of_build_ = 0;
  Vec3 centre_;  // A's mesh frame
  double longest_arm_ = 0;
  Coverage coverage_;           // of the list; around.linear negative: there is no list
  Coverage planned_;            // of the list under construction
  BuildPlan plan_;              // of the list under construction
  bool fallback_only_ = false;  // the build covers only the fallback
  // Stack of the build: one, large; none if capacity is 0.
  std::vector<PairStack<SlotPair>> to_visit_;
  bool unfinished_ = false;
  Transform X_;        // of the list
  Transform last_;     // the last pose from which travel is counted
  double linear_ = 0;  // m: travel of the centre, summed over the poses
  double turned_ = 0;  // rad: turn, summed likewise
};

}  // namespace sonde
