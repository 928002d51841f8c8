// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/pair_lists.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

/// The contacts near a free pose as linear inequalities (rows) on y. The least-distance problem
/// consists of these rows.
///
/// gather() makes rows of the nearest pairs of triangles. Where surfaces lie on each other, many
/// pairs have the same gap, and the nearest few may all belong to one corner. So these rows are a
/// first guess. cut() completes them: it checks the end of a step that the rows allow against all
/// pairs, and makes rows of the pairs that are in the way. The caller solves again and repeats this
/// until no pair is in the way (cutting planes; J. E. Kelley, 1960). An optimum of some of the
/// constraints that satisfies all of them is the optimum of all of them, so it does not matter
/// which rows are missing. Where there is no room for more rows, the step ends where its sweep
/// ends. Pairs that cut a step short, or that held an answer, are kept for the next gather.
///
/// Each direction that separates two triangles gives a half-space in which they stay apart. The
/// direction of their closest points is not the best one for every pair: beside a convex contact
/// it forbids sliding by more than half of the pair's offset. So gather() takes the nearest pair
/// first. A later pair takes over the normal of a nearer row if that normal separates it too, and
/// if a path that the pair is in the way of meets it no sooner along that normal than along its
/// own. The pair gets no row if the row would then add nothing.
class ContactRows {
 public:
  /// How many pairs of triangles are gathered, and how many a neighbour list may hold.
  struct Finding {
    /// A gather makes rows of at most this many pairs, the nearest. cut() finds the others.
    std::size_t most_pairs = contact_tuning.most_pairs;
    /// Pairs of a list that is kept from one gather to the next. 0: there is no list.
    std::size_t most_listed = NeighbourList::enough;
  };
  static constexpr std::size_t capacity = contact_tuning.most_rows;
  ContactRows(const Body& probe, const Body& fixed, Method method, const Finding& finding);

  /// Adds the time of looks, solutions and sweeps to `times` from now on; null: to nothing.
  void time_into(PhaseTimes* times) noexcept { times_ = times; }
  /// Keeps y in a subspace, onto which `onto` projects (6 × 6, symmetric), from now on. The y that
  /// it is asked about must lie there.
  void stay_within(const Mat6& onto) { onto_ = onto; }
  /// Drops all rows, kept pairs and lists. Call it before a pose that is unrelated to the last one.
  void forget() noexcept;

  /// Replaces the rows by those of the pairs within `reach` (m) of each other at y, or of the
  /// nearest of them where there are too many. A pair with a gap of at most `flat` (m) gives a row
  /// for each corner of the part in which its triangles overlap, not for one point alone. Returns
  /// false, with the old rows unchanged, if the effort ran out.
  bool gather(const Chart& chart, const Vec6& y, double reach, double flat,
              Effort& effort) noexcept;
  void gather(const Chart& chart, const Vec6& y, double reach, double flat) noexcept {
    Effort unlimited;
    gather(chart, y, reach, flat, unlimited);
  }

  /// Expresses the contacts of the last gather as rows in another chart, without a look at the
  /// geometry. y is the probe's pose in that chart. Returns false if that is not the pose of the
  /// last gather, or if the last gather did not finish.
  bool reuse_rows(const Chart& chart, const Vec6& y) noexcept;

  /// Moves the points on the probe, of all contacts, with the probe to y, and makes rows of them.
  /// This is for a tick without enough effort for a gather.
  void move_rows_with_probe(const Chart& chart, const Vec6& y) noexcept;

  /// Halves the reach of the next gather, but keeps at least `least` (m). Call it after a gather
  /// that took too much work. Each gather that fits lets the reach grow again.
  void halve_next_reach(double least) noexcept {
    reach_limit_ = std::max(contact_tuning.crowded_to * asked_, least);
  }

  /// Sweeps the probe along a motion (sweep.hpp). It looks at the pairs of the neighbour list if
  /// that list covers the motion, and otherwise at the trees of the bodies.
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

  /// Spends what a tick leaves of a limited effort on the next neighbour list.
  void prepare_next_list(Effort& effort) noexcept;

  /// Result of cut() at the end of a path.
  struct PathCheck {
    bool news = false;  ///< cut() added rows
    double lost = 0;    ///< m: the most that one pair would lose of min(its gap now, margin)
    bool clear = true;  ///< no pair is in the way; false also if the effort ran out
  };
  /// Checks the end of `motion`, a path from the pose of the last gather, which is y. A pair is in
  /// the way if its gap there is below 95 % (ContactTuning::kept_share) of min(its gap now,
  /// `margin`). Adds rows of the pairs in the way: of the 48 deepest at most
  /// (ContactTuning::most_cut).
  PathCheck cut(const Chart& chart, const Vec6& y, const Motion& motion, double margin,
                Effort& effort) noexcept;

  /// Replaces the direction of each row that holds a solution, but whose pair is not near, by the
  /// pair's own direction: a direction taken over from another row may be a wall where there is
  /// none. Returns whether it replaced any; then the solution is no longer valid.
  bool replace_far_rows(const Chart& chart, const Vec6& y, const LeastDistance& nearest,
                        double margin) noexcept;

  /// What solve() requires of a gap that is already smaller than the margin: that it does not
  /// shrink (keep), or that it grows to the margin (widen).
  enum class SmallGaps { keep, widen };
  /// Returns the y nearest to the origin at which every gap is at least `margin` (m), to first
  /// order; `small_gaps` says what applies to smaller gaps. `rise` (m) is added to the gap that
  /// each row requires.
  LeastDistance solve(double margin, SmallGaps small_gaps, double rise = 0) noexcept;

  Contact contact(int row) const { return contacts_[static_cast<std::size_t>(row)]; }
  /// The contacts that are active in a solution, with their multipliers.
  ContactSet holding(const LeastDistance& nearest) const noexcept;
  /// Jᵀλ of these contacts: the solution's y without the part that the rim of the chart holds.
  Vec6 held_by_contacts(const LeastDistance& nearest) const noexcept;
  int size() const { return static_cast<int>(count_); }  ///< number of rows
  /// True if there is no room for another row.
  bool is_full() const { return count_ == capacity; }
  double smallest_gap() const { return smallest_gap_; }  ///< m; the reach if there is no row
  /// m: the last gather found every pair with a gap up to this.
  double reach() const { return reach_; }

 private:
  struct TrianglePair {
    std::uint32_t a, b;
    bool operator==(const TrianglePair&) const = default;
  };
  /// The point of the probe about which the last contacts move least, in its mesh frame: their
  /// middle, if the probe rolls on them, or the centre of mass, if it turns within them.
  Vec3 least_moving_point(const Transform& X) const noexcept;
  /// m: a list that is made for a reach covers this much on all of its path.
  double near_of(double reach) const noexcept { return std::max(reach, 2 * least_asked_); }
  /// Finds the pairs within `reach` (m), or within the reach of the list if that is at least
  /// `least` (m).
  NearPairs find_pairs(const Transform& X, double reach, double least, Effort& effort) noexcept;
  void accept(const Contact& contact, const TrianglePair& of) noexcept;
  void keep(const TrianglePair& pair) noexcept;
  /// Appends the kept pairs within `reach` (m) at X to the first `count` pairs of `pairs_`, and
  /// forgets the other kept pairs. Returns the number of pairs with the new ones.
  std::size_t add_kept(const Transform& X, double reach, std::size_t count) noexcept;
  bool is_news(const Contact& contact) const noexcept;
  /// `end`: the end of the path that the pair is in the way of; null: no path is known.
  void take(const NearPair& pair, const Transform& X, double flat,
            const Transform* end = nullptr) noexcept;
  /// Makes rows of the contacts from index `from` up to `to`, in the chart at y, and the rim's row.
  void linearise(const Chart& chart, const Vec6& y, std::size_t from = 0,
                 std::size_t to = capacity) noexcept;

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  std::optional<Mat6> onto_;  // the motions that are allowed; none: all of the method
  PairLists lists_;
  std::size_t most_near_;
  std::vector<NearPair> pairs_;
  std::vector<Contact> contacts_;
  std::vector<HalfSpace> rows_;
  bool rim_ = false;        // the row after those of contacts is the rim of the chart
  std::vector<double> at_;  // J·y of each row
  std::vector<Violation> violations_;
  std::vector<TrianglePair> pair_of_;  // of each row
  /// Pairs that held an answer or cut a step short, the newest last. Every gather looks at them,
  /// however many other pairs are as near.
  std::vector<TrianglePair> kept_;
  std::size_t kept_count_ = 0;
  std::size_t count_ = 0;
  // m: no gather looks further. It falls where a reach holds more pairs than there is room for, and
  // grows again from gather to gather.
  double reach_limit_;
  double least_asked_ = 0;  // m: the least reach that suffices for the last gather
  double asked_ = 0;        // m: the reach that the last gather asked for
  double smallest_gap_ = 0;
  double reach_ = 0;
  Transform X_;            // of the last gather
  bool gathered_ = false;  // false: the last gather ran out of effort, or there was none
  PhaseTimes* times_ = nullptr;
  double turn_ = 0;  // rad: the turn that a step as long as the reach may make
};

}  // namespace sonde
