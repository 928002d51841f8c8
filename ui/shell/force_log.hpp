// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// Why the hand got no force: a line in the program's log for each time, and the last fault for the
/// screen, where it would be gone before anybody could read it.
class ForceLog {
 public:
  /// Each tick, in its order. One that is earlier than the last is the first of another run. What
  /// there is to say of it, empty where nothing has changed. A pose that is not settled is worth a
  /// word only where that lasts: the force fades, it is not cut.
  QString add(const Snapshot& tick);
  /// The loop has ended, with its program or for another scene; the next tick is of another run.
  void end();
  /// The fault of the last seconds before `time` (s since the start); empty where there was none.
  QString recent(double time) const;

 private:
  Withheld now_ = Withheld::nothing;
  Withheld fault_ = Withheld::nothing;  ///< the last one
  double fault_time_ = 0;               ///< s, of its last tick
  double settled_time_ = 0;             ///< s, of the last tick whose pose was settled
  double time_ = 0;
};

}  // namespace sonde::ui
