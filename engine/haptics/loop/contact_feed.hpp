// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "engine/haptics/loop/local_contacts.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/search/coherent.hpp"

namespace sonde {

/// The geometry's part of the decoupled loop, with no thread and no clock: follows the device with
/// the coherent solver, and gathers the rows of all that is near the separated pose, whether the
/// probe touches it or not. How near follows from the room for rows: as far as the pairs of
/// triangles are not too many. Where there is no room for all, those are kept first that would hold
/// the probe at other device poses round about; a flat contact has more rows than any number that
/// is kept, and what is nearest may be one corner of it.
class ContactFeed {
 public:
  ContactFeed(const Pair& pair, Method method);

  /// First pose: free, or a static search (by this feed's method), whose answer is remembered for
  /// the next time that the loop begins there. Allocates.
  const LocalContacts& reset(const Pose& X_FM, const StaticOptions& options);
  /// The next device pose, taken in a tick of the servo at a time of its clock, s. No allocation,
  /// lock, log, throw.
  const LocalContacts& refresh(const Pose& X_FM, std::uint64_t tick, double time,
                               const Budget& budget) noexcept;
  const LocalContacts& contacts() const noexcept { return contacts_; }

 private:
  const Separation& begin(const Pose& X_FM, const StaticOptions& options);
  void gather() noexcept;
  /// Marks the rows that would hold the probe if the device went elsewhere: on as it goes, or by
  /// `far` (m, for a point at the probe's radius) any of twelve ways.
  void mark_support(double far) noexcept;
  void mark_holding(const Pose& device) noexcept;

  Pair pair_;
  Method method_;
  CoherentSolver solver_;
  ContactRows near_;
  LocalContacts contacts_;
  Pose last_device_;
  std::vector<bool> marked_;  ///< of the rows near by
  /// What was found by the last search that was needed.
  std::optional<Separation> searched_;
};

}  // namespace sonde
