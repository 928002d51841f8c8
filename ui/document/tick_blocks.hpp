// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/recording/tick_log.hpp"

namespace sonde::ui {

/// The ticks of a log for another thread, while their own goes on adding to it.
struct TickBlocks {
  std::vector<BlockBytes> blocks;
  double probe_radius = 0;  ///< m
  double rate_hz = 0;
  double first = 0, last = 0;  ///< s, times of the ticks
  bool along_path = false;     ///< TickLog::along_path

  static TickBlocks of(const TickLog& log);
  /// They and the searches beside them again. Throws InputError where a file holds them no more.
  TickLog log() const;
};

}  // namespace sonde::ui
