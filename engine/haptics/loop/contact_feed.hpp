// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/loop/local_contacts.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/search/coherent.hpp"

namespace sonde {

/// The geometry's part of the decoupled loop, without thread or clock. It follows the device with
/// the coherent solver, and gathers rows for everything near the separated pose, touching or not.
/// Their reach depends on the room for rows: it is as large as the number of pairs permits.
/// If there is no room for all rows, it first keeps those that would hold the probe at other device
/// poses near by. A flat contact has more rows than any limit, and the nearest may all belong to
/// one corner of it.
class ContactFeed {
 public:
  ContactFeed(const Pair& pair, Method method);

  /// Starts at the first pose: it is free, or a static search (by this feed's method) finds the
  /// separated pose. Remembers that result for the next start at this pose. Allocates.
  const LocalContacts& reset(const Pose& X_FM, const StaticOptions& options);
  /// Follows to the next device pose, sampled in a tick of the servo at a time of its clock, s. No
  /// allocation, lock, log, throw. `budget` limits the solver. Gathering the rows may take a share
  /// of `of_rows` (LoopTuning::budget_of_rows), which need not grow with `budget`; with less, the
  /// rows have a smaller reach.
  const LocalContacts& refresh(const Pose& X_FM, std::uint64_t tick, double time,
                               const Budget& budget, const Budget& of_rows) noexcept;
  const LocalContacts& refresh(const Pose& X_FM, std::uint64_t tick, double time,
                               const Budget& budget) noexcept {
    return refresh(X_FM, tick, time, budget, budget);
  }
  /// Whether a separation reports where its time went, including that of the near rows, from the
  /// next refresh on.
  void time_phases(bool on) noexcept;
  const LocalContacts& contacts() const noexcept { return contacts_; }

 private:
  const Separation& begin(const Pose& X_FM, const StaticOptions& options);
  void gather(const Budget& budget) noexcept;
  /// Gathers the rows near the separated pose. If that is near the last one, or if no pairs could
  /// be found there, moves the last rows with the probe instead. Returns their reach from that
  /// pose, m.
  double gather_near(const Chart& chart, double flat, Effort& effort) noexcept;
  /// Gathers the rows at y. If the effort does not suffice to query the bodies, takes them from the
  /// solver's list of pairs, which has a smaller reach, and does so in the next refreshes without
  /// trying the bodies: 1, 3, 7, 15 and then 31 refreshes between two tries. Returns false if that
  /// list covers nothing either.
  bool look_around(const Chart& chart, const Vec6& y, double flat, Effort& effort) noexcept;
  /// Marks the rows that would hold the probe at other device poses near by: further along the
  /// device's motion, or moved by `far` (m, for a point at the probe's radius) in any of twelve
  /// directions.
  void mark_support(double far) noexcept;
  void mark_holding(const Pose& device) noexcept;

  Pair pair_;
  Method method_;
  CoherentSolver solver_;
  ContactRows near_;
  LocalContacts contacts_;
  PhaseTimes times_;  ///< of the near rows, if recorded
  Pose last_device_;
  Pose gathered_at_;  ///< of the near rows
  bool gathered_ = false;
  int failed_looks_ = 0;      ///< queries of the bodies in a row that ran out of effort
  int looks_left_out_ = 0;    ///< refreshes left until the next try
  std::vector<bool> marked_;  ///< of the near rows
  /// The result of the last search.
  std::optional<Separation> searched_;
};

}  // namespace sonde
