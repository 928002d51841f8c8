// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "engine/penetration/least_distance.hpp"
#include "engine/penetration/separation.hpp"
#include "engine/proximity/motion.hpp"
#include "engine/proximity/pair_list.hpp"

namespace sonde {

/// The contacts near a free pose, linearised: what the least-distance problem is made of.
///
/// Any direction that separates two triangles gives a half-space in which they stay apart, and the
/// direction of their closest points is not the best one for every pair: beside a convex contact it
/// forbids sliding by more than half of the pair's offset. So pairs are taken nearest first, and
/// one that the normal of a nearer row separates too takes over that normal; it is dropped where it
/// then says nothing new.
class ContactRows {
 public:
  /// How pairs are found: the nearest so many at most, and where steps are short by a list that is
  /// kept from one gather to the next.
  struct Finding {
    std::size_t most_pairs = 512;
    std::size_t most_listed = PairList::enough;  ///< 0: no list
  };
  ContactRows(const Body& probe, const Body& fixed, Method method, const Finding& finding);

  /// What comes next has nothing to do with what was gathered before.
  void forget() noexcept;

  /// Linearises at y all pairs within reach (or the nearest of them, where there are too many).
  /// Pairs no further apart than `flat` give a row for each corner of their overlay, not for one
  /// point alone. False, and nothing new, where the effort ran out.
  bool gather(const Chart& chart, const Vec6& y, double reach, double flat,
              Effort& effort) noexcept;
  void gather(const Chart& chart, const Vec6& y, double reach, double flat) noexcept {
    Effort unlimited;
    gather(chart, y, reach, flat, unlimited);
  }

  /// The contacts of the last gather as rows in another chart, in which the probe stands at y.
  /// False where that is not where they were gathered, or there was none.
  bool again(const Chart& chart, const Vec6& y) noexcept;

  /// The contacts of the last gather that was not cut short, moved with the probe to y: all there
  /// is where there was no effort to look.
  void carry(const Chart& chart, const Vec6& y) noexcept;

  /// The last gather was too much work: the next ones have half of its reach, but no less than that
  /// (m), and then more again.
  void look_less_far(double least) noexcept { crowded_ = std::max(0.5 * asked_, least); }

  /// The longest path, m, for any point of the probe, that a sweep from y is quick for. No limit
  /// where surfaces are near each other here and there; where they lie along each other over a wide
  /// area (a peg in its hole), walking the trees for a long path costs more than many short ones
  /// along the list.
  double quick_path(const Chart& chart, const Vec6& y) const noexcept;

  /// Sweeps the probe along a motion; a list of pairs serves where the path is short.
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

  /// What becomes of a gap that is smaller than the margin already.
  enum class Narrow { keep, open };
  /// The point nearest to the origin that keeps every gap at `margin` or more, to first order.
  LeastDistance solve(double margin, Narrow narrow) noexcept;

  Contact contact(int row) const { return contacts_[static_cast<std::size_t>(row)]; }
  /// The contacts that hold a solution, with their multipliers.
  ContactSet holding(const LeastDistance& nearest) const noexcept;
  int size() const { return static_cast<int>(count_); }
  double smallest_gap() const { return smallest_gap_; }  ///< m; the reach where there is no row
  double reach() const { return reach_; }

 private:
  /// A point of the probe among the last contacts, or its centre of mass.
  Vec3 middle() const noexcept;
  /// Makes the list anew, about `centre`, for paths such as the next one; not where that is long
  /// and the list would not pay.
  void list_pairs(const Transform& X, double reach, const Vec3& centre,
                  const PairList::Displacement& ahead, Effort& effort) noexcept;
  NearPairs find_pairs(const Transform& X, double reach, Effort& effort) noexcept;
  void accept(const Contact& contact) noexcept;
  bool is_news(const Contact& contact) const noexcept;
  void take(const NearPair& pair, const Transform& X, double flat) noexcept;
  /// Makes the rows of the contacts, at y.
  void linearise(const Chart& chart, const Vec6& y) noexcept;

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  PairList list_;
  std::vector<NearPair> pairs_;
  std::vector<Contact> contacts_;
  std::vector<HalfSpace> rows_;
  std::vector<double> at_;  // J·y of each row
  std::size_t count_ = 0;
  // Reaches found to hold more pairs than there is room for; they grow again with time.
  double crowded_;
  double list_limit_;
  double list_reach_;             // at which the list has a good size
  PairList::Displacement usual_;  // along the paths of late
  double asked_ = 0;              // reach of the last gather
  double smallest_gap_ = 0;
  double reach_ = 0;
  Transform X_;            // of the last gather
  bool gathered_ = false;  // false: it ran out of effort, or there was none
  double turn_ = 0;        // rad, that a step of the size of the reach may make
};

}  // namespace sonde
