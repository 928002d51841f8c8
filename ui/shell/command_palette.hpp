// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QAction;
class QLineEdit;
class QListWidget;
class QMenuBar;

namespace sonde::ui {

/// All that the menus can do, searched by words: Enter does it.
class CommandPalette : public QDialog {
 public:
  CommandPalette(QMenuBar& menus, QWidget* parent);
  /// What was chosen; null where nothing was. To be triggered once the palette is gone.
  QAction* chosen() const { return chosen_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void filter(const QString& words);
  void take();

  QLineEdit* words_;
  QListWidget* found_;
  QAction* chosen_ = nullptr;
};

/// Asks, and does what is chosen.
void find_command(QMenuBar& menus, QWidget& window);

}  // namespace sonde::ui
