// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/penetration/contact/kept_pairs.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/pair_lists.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

/// Linearises the contacts near a free pose. Each contact gives a row: a linear inequality on y,
/// the probe's coordinates in a chart. The rows are the constraints of the least-distance problem.
///
/// gather() makes rows of the nearest pairs of triangles. Where surfaces lie on each other, many
/// pairs have the same gap, and the nearest few may all belong to one corner. So these rows are a
/// first guess. add_cuts() completes them: it tests the pose at the end of a step that the rows
/// allow against all pairs, and adds rows for the pairs that obstruct the step. The caller solves
/// again and repeats this until no pair obstructs the step (cutting planes; J. E. Kelley, 1960). If
/// the optimum for some of the constraints satisfies all of them, it is also the optimum for all of
/// them, so the rows that are still missing do not matter. If there is no room for more rows, the
/// sweep decides how far the step goes. Pairs that obstructed a step, or that were active in a
/// solution, are kept for the next gather.
///
/// Each direction that separates two triangles gives a half-space in which they stay apart. The
/// direction of their closest points is not the best one for every pair: beside a convex contact it
/// forbids sliding by more than half of the pair's offset from the contact. So gather() processes
/// the pairs in the order of their gaps, the nearest first. A later pair uses the normal of an
/// earlier row if that normal separates its triangles too. For a pair that obstructs a path there
/// is a second condition: on that path, its gap along the earlier row's normal must not close
/// sooner than along its own normal. A pair gets no row if an existing row already implies it.
class ContactRows {
 public:
  /// How many pairs of triangles are gathered, and how many a neighbour list may hold.
  struct Finding {
    /// A gather makes rows of at most this many pairs, the nearest. add_cuts() finds the others.
    std::size_t most_pairs = contact_tuning.most_pairs;
    /// Whether neighbour lists are kept from one gather to the next.
    bool keeps_lists = true;
  };
  static constexpr std::size_t capacity = contact_tuning.most_rows;
  ContactRows(const Body& probe, const Body& fixed, Method method, const Finding& finding);

  /// From now on, adds the time spent on geometry queries, least-distance problems and sweeps to
  /// `times`. Null: records no times.
  void time_into(PhaseTimes* times) noexcept { times_ = times; }
  /// From now on, restricts y to the subspace onto which `onto` (6 × 6, symmetric) projects. Every
  /// y passed to this object must lie in that subspace.
  void stay_within(const Mat6& onto) { onto_ = onto; }
  /// Drops all rows, kept pairs and lists. Call it before a pose that is unrelated to the last one.
  void forget() noexcept;

  /// Replaces the rows by those of the pairs of triangles that are within `reach` (m) of each other
  /// at y. If there are too many such pairs, only the nearest give rows. A pair with a gap of at
  /// most `flat` (m) gives a row not only for its closest points, but also for each corner of the
  /// overlap of its triangles. Returns false, with the old rows unchanged, if the effort ran out.
  bool gather(const Chart& chart, const Vec6& y, double reach, double flat,
              Effort& effort) noexcept;
  void gather(const Chart& chart, const Vec6& y, double reach, double flat) noexcept {
    Effort unlimited;
    gather(chart, y, reach, flat, unlimited);
  }
  /// The same from another list of pairs of these bodies, within what it covers at y. Returns
  /// false, with the old rows unchanged, if it covers nothing there.
  bool gather_from(NeighbourList& list, const Chart& chart, const Vec6& y, double reach,
                   double flat) noexcept;
  /// The list of pairs in use; it may cover nothing.
  NeighbourList& list() noexcept { return lists_.serving(); }

  /// Expresses the contacts of the last gather as rows in another chart, without a query of the
  /// geometry. y is the probe's pose in that chart. Returns false if that is not the pose of the
  /// last gather, or if the last gather did not finish.
  bool reuse_rows(const Chart& chart, const Vec6& y) noexcept;

  /// Moves the probe's point of every contact with the probe to y, and makes the rows again from
  /// these contacts. For a tick whose effort does not suffice for a gather.
  void move_rows_with_probe(const Chart& chart, const Vec6& y) noexcept;

  /// Limits the reach of the next gather to half of the last one's, but to no less than `least`
  /// (m). Call it after a gather that took too much work. Each later gather whose pairs fit raises
  /// the limit again.
  void halve_next_reach(double least) noexcept {
    reach_limit_ = std::max(contact_tuning.crowded_to * asked_, least);
  }

  /// Sweeps the probe along a motion (sweep.hpp). It examines the pairs of the neighbour list if
  /// that list covers the motion, and otherwise traverses the trees of the bodies.
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

  /// Works on the next neighbour list with the part of a limited effort that the tick has not used.
  /// The list is made for ticks in which the device moves by `moved` (m), as in this one. (A probe
  /// that catches up moves farther in a tick, but making a list for many such ticks would take
  /// longer than the catching up.)
  void prepare_next_list(double moved, Effort& effort) noexcept;

  /// Result of add_cuts() at the end of a path.
  struct PathCheck {
    bool news = false;   ///< add_cuts() added rows
    double lost = 0;     ///< m: largest loss of a pair: min(gap now, margin) − gap at the end
    bool clear = true;   ///< no pair obstructs the path; false also if the effort ran out
    bool looked = true;  ///< false: a limited effort did not suffice for a list, so none is known
  };
  /// Checks the pose at the end of `motion`, a path that begins at y, the pose of the last gather.
  /// A pair obstructs the path if its gap at the end is below 95 % (ContactTuning::kept_share) of
  /// min(its gap at y, `margin`). Adds rows for the obstructing pairs, at most for the 48 deepest
  /// (ContactTuning::most_cut).
  PathCheck add_cuts(const Chart& chart, const Vec6& y, const Motion& motion, double margin,
                     Effort& effort) noexcept;

  /// Looks for active rows of a solution whose pair of triangles is in fact far apart, and replaces
  /// their normal by the direction of the pair's own closest points: a normal taken over from
  /// another row may forbid motions that the pair does not obstruct. Returns whether any row
  /// changed; the solution is then no longer valid.
  bool replace_far_rows(const Chart& chart, const Vec6& y, const LeastDistance& nearest,
                        double margin) noexcept;

  /// Looks for an active row of a solution whose pair of triangles is also separated by another
  /// axis, along which it forbids less: the free poses of a pair are the union of the half-spaces
  /// of its separating axes, and a solution that is the best of one of them need not be the best of
  /// all. Replaces the first such row that shortens the solution by more than `enough` (m), and
  /// returns whether there was one; the solution is then no longer valid.
  bool replace_blocking_row(const Chart& chart, const Vec6& y, const LeastDistance& nearest,
                            double margin, double enough) noexcept;

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
  /// Jᵀλ of these contacts: the solution's y less the contribution of the row that stands for the
  /// rim of the chart.
  Vec6 held_by_contacts(const LeastDistance& nearest) const noexcept;
  int size() const { return static_cast<int>(count_); }  ///< number of rows
  /// True if there is no room for another row.
  bool is_full() const { return count_ == capacity; }
  double smallest_gap() const { return smallest_gap_; }  ///< m; the reach if there is no row
  /// m: the last gather found every pair with a gap up to this.
  double reach() const { return reach_; }

 private:
  /// Makes the rows of the pairs found at y, and of those kept from before within `reach` (m).
  void make_rows(const NearPairs& near, double reach, const Chart& chart, const Vec6& y,
                 double flat, Effort& effort) noexcept;
  /// The point, in the probe's mesh frame, about which motions are measured: the mean of the last
  /// contacts or the centre of mass, whichever gives the smaller bounds of the contacts' motion on
  /// the recent course. It is the mean if the probe rolls on the contacts, the centre of mass if
  /// the probe turns within them.
  Vec3 least_moving_point(const Transform& X) const noexcept;
  /// m: the reach that a list made for `reach` should have everywhere on its path.
  double near_of(double reach) const noexcept { return std::max(reach, 2 * least_asked_); }
  /// Finds the pairs within `reach` (m) of each other. If the neighbour list has a smaller reach,
  /// but at least `least` (m) and ContactTuning::least_share_of_reach of `reach`, that smaller
  /// reach is used.
  NearPairs find_pairs(const Transform& X, double reach, double least, Effort& effort) noexcept;
  void accept(const Contact& contact, const TrianglePair& of) noexcept;
  bool is_news(const Contact& contact) const noexcept;
  /// The part of a row that the method allows.
  Vec6 allowed(Vec6 row) const noexcept;
  /// `end`: the pose at the end of the path that the pair obstructs; null: no path is known.
  void add_rows_of(const NearPair& pair, const Transform& X, double flat,
                   const Transform* end = nullptr) noexcept;
  /// The solution without the k-th of the rows that hold `nearest`.
  LeastDistance without_row(const LeastDistance& nearest, std::size_t k, double margin) noexcept;
  /// Makes rows of the contacts from index `from` up to `to`, in the chart at y, and the row of the
  /// chart's rim.
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
  KeptPairs kept_;
  std::size_t count_ = 0;
  // m: limit of the reach of a gather. It falls after a gather that found more pairs than there is
  // room for, and grows again from gather to gather.
  double reach_limit_;
  double least_asked_ = 0;  // m: the least reach that suffices for the last gather
  double asked_ = 0;        // m: the reach that the last gather asked for
  double smallest_gap_ = 0;
  double reach_ = 0;
  Transform X_;  // of the last gather
  /// Some row was replaced (replace_blocking_row). At another pose, its axis may forbid motions
  /// that the pair's own direction allows, so the rows must not be reused at the next pose.
  bool has_other_axes_ = false;
  bool gathered_ = false;  // false: the last gather ran out of effort, or there was none
  PhaseTimes* times_ = nullptr;
  double turn_ = 0;  // rad: largest expected turn of the next step
};

}  // namespace sonde
