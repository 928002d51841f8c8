// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

#include "engine/recording/curves.hpp"
#include "engine/recording/recording.hpp"

namespace sonde::ui {

/// Ticks with their curves, to look back on.
struct KeptTicks {
  QString name;
  std::unique_ptr<Recording> recording;  ///< of a file
  std::unique_ptr<TickLog> ticks;        ///< of a run in memory
  Curves curves;
  const TickLog& log() const { return recording ? recording->ticks : *ticks; }
};

}  // namespace sonde::ui
