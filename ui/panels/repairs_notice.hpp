// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "ui/panels/repairs_bar.hpp"

class QAction;

namespace sonde::ui {

/// What was mended of the bodies on show, in what is left of the tool bar, so that it takes nothing
/// from the view: a button that unfolds the bar, and a few words for each body.
class RepairsNotice : public QWidget {
 public:
  explicit RepairsNotice(QWidget* parent);

  void show_row(std::size_t body, const std::optional<RepairsRow>& row);
  /// Its button's.
  void set_action(QAction* action);

 private:
  struct Widgets {
    QWidget* row;
    ElidedLabel* text;
  };
  Widgets make_row(std::size_t body);

  QToolButton* button_;
  std::array<Widgets, 2> rows_;
};

}  // namespace sonde::ui
