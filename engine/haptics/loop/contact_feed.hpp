// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/loop/local_contacts.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/search/coherent.hpp"

namespace sonde {

/// The geometry's part of the decoupled loop, with no thread and no clock. It follows the device
/// with the coherent solver, and gathers rows for everything near the separated pose, touched or
/// not. The room for rows decides how near: as far as the pairs of triangles are not too many.
/// Where there is no room for all rows, it first keeps those that would hold the probe at other
/// device poses nearby. A flat contact has more rows than any limit, and the nearest may all belong
/// to one corner of it.
class ContactFeed {
 public:
  ContactFeed(const Pair& pair, Method method);

  /// The first pose: free, or a static search (by this feed's method). It remembers the result for
  /// the next start at this pose. Allocates.
  const LocalContacts& reset(const Pose& X_FM, const StaticOptions& options);
  /// The next device pose, taken in a tick of the servo at a time of its clock, s. No allocation,
  /// lock, log, throw.
  const LocalContacts& refresh(const Pose& X_FM, std::uint64_t tick, double time,
                               const Budget& budget) noexcept;
  /// From the next refresh on, whether its separation says where the time went, with that of the
  /// rows near by.
  void time_phases(bool on) noexcept;
  const LocalContacts& contacts() const noexcept { return contacts_; }

 private:
  const Separation& begin(const Pose& X_FM, const StaticOptions& options);
  void gather(const Budget& budget) noexcept;
  /// Gathers the rows near the separated pose. Where it is near the last one, or the effort runs
  /// out, it moves the last rows there with the probe. Returns how far they reach from there, m.
  double gather_near(const Chart& chart, double flat, Effort& effort) noexcept;
  /// Marks the rows that would hold the probe if the device moved elsewhere: further along its
  /// motion, or by `far` (m, for a point at the probe's radius) in any of twelve directions.
  void mark_support(double far) noexcept;
  void mark_holding(const Pose& device) noexcept;

  Pair pair_;
  Method method_;
  CoherentSolver solver_;
  ContactRows near_;
  LocalContacts contacts_;
  PhaseTimes times_;  ///< of the rows near by, where they are kept
  Pose last_device_;
  Pose gathered_at_;  ///< of the rows near by
  bool gathered_ = false;
  std::vector<bool> marked_;  ///< of the rows near by
  /// The result of the last search.
  std::optional<Separation> searched_;
};

}  // namespace sonde
