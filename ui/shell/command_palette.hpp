// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QAction;
class QLineEdit;
class QListWidget;
class QMenuBar;

namespace sonde::ui {

/// A search through all commands of the menus by their words; Enter runs the chosen one.
class CommandPalette : public QDialog {
 public:
  CommandPalette(QMenuBar& menus, QWidget* parent);
  /// The chosen command; null where there is none. Trigger it once the palette is closed.
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

/// Asks for a command and runs it.
void find_command(QMenuBar& menus, QWidget& window);

}  // namespace sonde::ui
