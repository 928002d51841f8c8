// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// Reports why the hand got no force: a line in the program's log each time, and the last fault for
/// the screen, where it would otherwise vanish before anybody could read it.
class ForceLog {
 public:
  /// Takes each tick, in order. A tick that is earlier than the last is the first of another run.
  /// Returns the message, empty where nothing has changed. A pose that is not settled gets a
  /// message only where that lasts, because the force then fades and is not cut. That a hand is put
  /// into a scene that has just been set up gets none.
  QString add(const Snapshot& tick);
  /// The loop has ended, with the program or for another scene; the next tick belongs to another
  /// run.
  void end();
  /// The fault of the last seconds before `time` (s since the start); empty where there was none.
  QString recent(double time) const;

 private:
  Withheld now_ = Withheld::nothing;
  Withheld fault_ = Withheld::nothing;  ///< the last one
  double fault_time_ = 0;               ///< s, of its last tick
  double settled_time_ = 0;             ///< s, of the last tick whose pose was settled
  double time_ = 0;
  bool felt_ = false;  ///< there has been a force
};

}  // namespace sonde::ui
