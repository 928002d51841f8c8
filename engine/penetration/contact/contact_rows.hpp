// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/pair_lists.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/sweep/motion.hpp"

namespace sonde {

/// The contacts near a free pose, linearised: what the least-distance problem is made of.
///
/// Where surfaces lie on each other any number of pairs is as near as any other, and the nearest
/// few that are gathered may be those of one corner. So they are a guess, and what makes the rows
/// complete is cut(): the end of a step that the rows allow is looked at, over all pairs there are,
/// and what is in its way becomes rows too, until nothing is (cutting planes; J. E. Kelley, 1960).
/// Pairs that cut a step short or held an answer are kept for the next gather. An optimum of some
/// of the constraints that satisfies all of them is the optimum of all of them: it does not matter
/// which rows are missing. Where there is no room for more rows the step ends where its sweep does.
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
    std::size_t most_pairs = contact_tuning.most_pairs;  ///< a first guess: cut() finds the rest
    std::size_t most_listed = NeighbourList::enough;     ///< 0: no list
  };
  static constexpr std::size_t capacity = contact_tuning.most_rows;
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
  void look_less_far(double least) noexcept {
    crowded_ = std::max(contact_tuning.crowded_to * asked_, least);
  }

  /// Sweeps the probe along a motion; a list of pairs serves where the path is short.
  Sweep sweep_along(const Motion& motion, double clearance, Effort& effort) noexcept;

  /// What a tick leaves over of a limited effort goes into the list that comes next.
  void look_ahead(Effort& effort) noexcept;

  /// What is in the way of a step that is thought of.
  struct Look {
    bool news = false;  ///< rows were added
    double lost = 0;    ///< m: the most that a pair would lose of its gap, or of the margin
    bool clear = true;  ///< none does; false where the effort ran out
  };
  /// Looks at the end of a path from the last gather, at y, for pairs that would be nearer there
  /// than the margin, or where they are nearer already than they are, and adds rows of those that
  /// come nearest.
  Look cut(const Chart& chart, const Vec6& y, const Motion& motion, double margin,
           Effort& effort) noexcept;

  /// What becomes of a gap that is smaller than the margin already.
  enum class Narrow { keep, open };
  /// The point nearest to the origin that keeps every gap at `margin` or more, to first order. What
  /// is held at its gap rises by so much more.
  LeastDistance solve(double margin, Narrow narrow, double rise = 0) noexcept;

  Contact contact(int row) const { return contacts_[static_cast<std::size_t>(row)]; }
  /// The contacts that hold a solution, with their multipliers.
  ContactSet holding(const LeastDistance& nearest) const noexcept;
  /// What they hold of it, Jᵀλ: all of it but what the rim of the chart does.
  Vec6 held_by_contacts(const LeastDistance& nearest) const noexcept;
  int size() const { return static_cast<int>(count_); }
  /// There is no room for another row.
  bool is_full() const { return count_ == capacity; }
  double smallest_gap() const { return smallest_gap_; }  ///< m; the reach where there is no row
  double reach() const { return reach_; }

 private:
  struct TrianglePair {
    std::uint32_t a, b;
    bool operator==(const TrianglePair&) const = default;
  };
  /// The point of the probe about which its contacts move least: the middle of the last ones, where
  /// it rolls on them, or its centre of mass, where it turns within them.
  Vec3 stillest(const Transform& X) const noexcept;
  /// m: so much a list for a reach is to hold at any time.
  double near_of(double reach) const noexcept { return std::max(reach, 2 * least_asked_); }
  /// The pairs within reach, or within what the list holds, if that is not below `least`.
  NearPairs find_pairs(const Transform& X, double reach, double least, Effort& effort) noexcept;
  void accept(const Contact& contact, const TrianglePair& of) noexcept;
  void keep(const TrianglePair& pair) noexcept;
  /// Puts the kept pairs that are within reach at X behind so many others; returns how many it are.
  std::size_t add_kept(const Transform& X, double reach, std::size_t count) noexcept;
  bool is_news(const Contact& contact) const noexcept;
  void take(const NearPair& pair, const Transform& X, double flat) noexcept;
  /// Makes the rows of the contacts, at y.
  void linearise(const Chart& chart, const Vec6& y, std::size_t from = 0) noexcept;

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  PairLists lists_;
  std::size_t most_near_;
  std::vector<NearPair> pairs_;
  std::vector<Contact> contacts_;
  std::vector<HalfSpace> rows_;
  bool rim_ = false;        // the row behind the last is the rim of the chart
  std::vector<double> at_;  // J·y of each row
  std::vector<Violation> violations_;
  std::vector<TrianglePair> pair_of_;  // of each row
  /// Pairs that held an answer or cut a step short, the last one last: they are looked at again
  /// wherever the probe has come to, however many others are as near.
  std::vector<TrianglePair> kept_;
  std::size_t kept_count_ = 0;
  std::size_t count_ = 0;
  // Reaches found to hold more pairs than there is room for; they grow again with time.
  double crowded_;
  double least_asked_ = 0;  // m: reach that a gather must have
  double asked_ = 0;        // reach of the last gather
  double smallest_gap_ = 0;
  double reach_ = 0;
  Transform X_;            // of the last gather
  bool gathered_ = false;  // false: it ran out of effort, or there was none
  double turn_ = 0;        // rad, that a step of the size of the reach may make
};

}  // namespace sonde
