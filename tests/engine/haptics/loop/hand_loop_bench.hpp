// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "engine/haptics/loop/contact_feed.hpp"
#include "engine/haptics/loop/hand_loop.hpp"
#include "tests/engine/haptics/loop/at_depth.hpp"
#include "tests/engine/haptics/tick_time.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {

inline HandLoopSettings at_once() {
  HandLoopSettings s;
  s.safety.ramp_time = s.safety.force_slew = s.safety.torque_slew = 0;
  s.safety.change_rate = {.force = 0, .torque = 0};
  return s;
}

/// A loop whose geometry answers as late as the test wants.
class HandLoopBench {
 public:
  /// `height` of the block, m; its top is where at_depth() has it.
  explicit HandLoopBench(const HandLoopSettings& settings = at_once(),
                         const Coupling& coupling = {}, double height = 0.1)
      : fixed(body(box({3 * height, 3 * height, height}))),
        loop(probe->mass, Method::pdg, coupling, settings),
        sunk_((height - 0.1) / 2) {
    Pose start = at_depth(-0.001);
    start.p.z() += sunk_;
    feed.reset(start, {});
    loop.restart(at_depth(-0.001));
  }
  const HandTick& tick(const HandSample& sample, bool geometry = true,
                       Withheld why = Withheld::nothing) {
    const HandLoop::Clock clock{.tick = ++ticks_, .now = double(ticks_) * dt, .dt = dt};
    const HandTick& out = loop.tick(sample, raised_contacts(), clock, why);
    Pose seen = loop.device();
    seen.p.z() -= raised - sunk_;
    if (geometry) feed.refresh(seen, clock.tick, clock.now, {});
    return out;
  }
  /// A tick's time in which nothing is computed.
  void rest(Withheld why) {
    ++ticks_;
    loop.rest(why);
  }
  const HandTick& tick(double depth) { return tick({.X_FM = at_depth(depth)}); }
  void settle(double depth, int ticks = 500) {
    for (int i = 0; i < ticks; ++i) tick(depth);
  }

  std::shared_ptr<const Body> probe = body(box({0.02, 0.03, 0.05}));
  std::shared_ptr<const Body> fixed;
  ContactFeed feed{{probe, fixed}, Method::pdg};
  HandLoop loop;
  double raised = 0;  ///< m: the fixed body is so much higher; a change is a jump of the contact

 private:
  LocalContacts raised_contacts() const {
    LocalContacts contacts = feed.contacts();
    for (int i = 0; i < contacts.size; ++i)
      contacts.rows[std::size_t(i)].on_fixed.z() += raised - sunk_;
    contacts.separation.device.p.z() += raised - sunk_;
    contacts.separation.separated.p.z() += raised - sunk_;
    return contacts;
  }

  double sunk_;  ///< m, the block's middle
  std::uint64_t ticks_ = 0;
};

}  // namespace sonde::test
