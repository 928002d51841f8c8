// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <optional>

#include "ui/tuning/last_second.hpp"

class QLabel;

namespace sonde::ui {

class HistoryPlot;

/// The figures of the last second of the servo in words, and the chatter's curve since the pair was
/// opened.
class LastSecondBox : public QGroupBox {
 public:
  explicit LastSecondBox(QWidget* parent = nullptr);

  /// At the time (s) of the newest tick; none: nothing has run for a second.
  void show_buzz(const std::optional<Buzz>& buzz, double time);
  /// A pair was opened: the curve starts over.
  void clear_history();

 private:
  QLabel *chatter_, *energy_, *rendered_;
  HistoryPlot* chatter_plot_;
};

}  // namespace sonde::ui
