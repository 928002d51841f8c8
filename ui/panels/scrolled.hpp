// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QDockWidget;
class QScrollArea;
class QVBoxLayout;
class QWidget;

namespace sonde::ui {

/// What a dock is filled by: a column of groups that scrolls up and down where it is too long.
struct Scrolled {
  QScrollArea* scroll;
  QWidget* content;
  QVBoxLayout* layout;  ///< of the content
};

/// An empty one, in the dock.
Scrolled scrolled(QDockWidget& dock);

}  // namespace sonde::ui
