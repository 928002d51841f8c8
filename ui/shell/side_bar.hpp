// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>
#include <map>
#include <vector>

class QDockWidget;

namespace sonde::ui {

/// A strip along a side of the window with a tab for each dock. A click on a tab opens its dock in
/// place of the one that is open in that area, and a click on the tab of the open one folds it
/// away, so that the view has the room. Docks that float stay as they are.
class SideBar : public QToolBar {
 public:
  /// `object`: the name under which the window's state keeps it.
  SideBar(Qt::ToolBarArea side, const QString& title, const char* object, QWidget* window);

  /// A tab for a dock that the window has.
  void add(QDockWidget& dock);
  void add_space();
  const std::vector<QDockWidget*>& docks() const { return docks_; }
  /// Docks that come open keep the width that they have, as at first, while a state is restored.
  void hold_widths(bool on) { held_ = on; }
  /// Each frame of a window on show: how wide the docks are that are open, before another opens and
  /// the window takes room from all of them alike.
  void note_widths();

  static constexpr int first_width = 272;  ///< pixels, of a dock

 private:
  void on_opened(QDockWidget& opened);

  bool reads_upwards_;
  bool held_ = true;
  int width_ = first_width;  ///< of what was open last
  std::vector<QDockWidget*> docks_;
  std::map<const QDockWidget*, int> noted_;  ///< those beside the view, of both sides
};

}  // namespace sonde::ui
