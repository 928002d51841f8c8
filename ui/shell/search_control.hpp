// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>
#include <optional>

#include "ui/shell/search_schedule.hpp"

namespace sonde::ui {

class HistoryControl;
class Session;
class Viewport;

/// The searches beside the ticks, PD_t and the lower bound, in a thread of their own: asks for them
/// while they are wanted, draws and keeps what they find.
class SearchControl {
 public:
  SearchControl(Viewport& view, HistoryControl& history) : view_(view), history_(history) {}

  /// What was found last for the pose that is shown; none: nothing is known.
  const std::optional<BackgroundResult>& newest() const { return schedule_.newest(); }
  /// The pair or the pose is another: what was found is of no use.
  void forget() { schedule_.forget(); }
  /// Whether the view draws what is found.
  bool is_drawn() const;
  /// With every frame: `followed`, what the ticks follow now. Not wanted: nothing is asked for, and
  /// nothing is known of the nearest way out from then on.
  void frame(Session& session, const Separation& followed, qint64 now, bool wanted);

 private:
  void end(Session& session);

  Viewport& view_;
  HistoryControl& history_;
  SearchSchedule schedule_;
};

}  // namespace sonde::ui
