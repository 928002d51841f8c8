// SPDX-License-Identifier: GPL-3.0-or-later
// The window's docks and strips, how it keeps them, and what is dropped on it.

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QLayout>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QTimer>
#include <QUrl>
#include <utility>

#include "engine/haptics/loop/hand_loop.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/panels/device_panel.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/readout_panel.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/side_bar.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
/// At the first start one dock is open, and the view is the largest thing.
void MainWindow::add_sides() {
  left_ = new SideBar(Qt::LeftToolBarArea, QStringLiteral("Docks at the left"), "left_bar", this);
  right_ =
      new SideBar(Qt::RightToolBarArea, QStringLiteral("Docks at the right"), "right_bar", this);
  addToolBar(Qt::LeftToolBarArea, left_);
  addToolBar(Qt::RightToolBarArea, right_);
  QDockWidget* const timeline = &history_->timeline();
  QDockWidget *const plots = &history_->plots(), *const log = log_;
  for (QDockWidget* dock : findChildren<QDockWidget*>())
    dock->setVisible(dock == readout_ || dock == timeline);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) {
    if (dockWidgetArea(dock) == Qt::LeftDockWidgetArea) left_->add(*dock);
    if (dockWidgetArea(dock) == Qt::RightDockWidgetArea) right_->add(*dock);
  }
  right_->add_space();
  right_->add(*plots);
  right_->add(*log);
}

std::vector<QDockWidget*> MainWindow::docks_of_sides() const {
  std::vector<QDockWidget*> docks = left_->docks();
  docks.insert(docks.end(), right_->docks().begin(), right_->docks().end());
  return docks;
}

void MainWindow::fold_docks() {
  std::vector<QDockWidget*> open;
  for (QDockWidget* dock : docks_of_sides())
    if (!dock->isHidden() && !dock->isFloating()) open.push_back(dock);
  const bool any = !open.empty();
  if (any) folded_ = open;
  for (QDockWidget* dock : folded_) dock->setVisible(!any);
}

/// The start page has the window to itself, and so has a question about what is being opened: docks
/// about nothing would be empty.
void MainWindow::clear_desk() {
  if (!desk_.isEmpty()) return;
  desk_ = saveState(state_version);
  for (QDockWidget* dock : findChildren<QDockWidget*>()) dock->hide();
  for (SideBar* bar : {left_, right_}) bar->hide();
}

void MainWindow::lay_desk() {
  if (desk_.isEmpty()) return;
  for (SideBar* bar : {left_, right_}) bar->hold_widths(true);  // until the next frame
  restoreState(std::exchange(desk_, {}), state_version);
  layout()->activate();  // the view has its size before anything is fitted into it
}

void MainWindow::show_device_dock() { device_panel_->show(); }

/// The first window leaves room for its frame and for the desktop's own bars.
void MainWindow::restore_window() {
  constexpr double part = 0.9;
  resize((QApplication::primaryScreen()->availableSize() * part).boundedTo({1440, 900}));
  resizeDocks({readout_}, {SideBar::first_width}, Qt::Horizontal);
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("docks")).toByteArray(), state_version);
}

/// Esc ends the force of a device at once, as long as there is a window: it closes once a force
/// that is felt has fallen.
void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closing_.isValid()) {
    if (!documents_->may_leave()) return event->ignore();
    QSettings settings;
    settings.setValue(QStringLiteral("geometry"), saveGeometry());
    settings.setValue(QStringLiteral("docks"), desk_.isEmpty() ? saveState(state_version) : desk_);
    if (felt_ && session()) let_go_to_close();
  }
  constexpr auto longest_ms = static_cast<qint64>(1000 * HandLoop::longest_fade) + 500;
  if (closing_.isValid() && !closing_.hasExpired(longest_ms) && !endings_.unended().empty())
    return event->ignore();
  QMainWindow::closeEvent(event);
}

/// The force falls, and the window closes after that.
void MainWindow::let_go_to_close() {
  constexpr int look_every_ms = 10;
  closing_.start();
  show_nothing();
  setAcceptDrops(false);
  menuBar()->setEnabled(false);
  start_page_->setEnabled(false);
  statusBar()->showMessage(
      QStringLiteral("Letting go of the device, then closing. Esc ends its force at once."));
  auto* look = new QTimer(this);
  connect(look, &QTimer::timeout, this, &QWidget::close);
  look->start(look_every_ms);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList files, others;
  for (const QUrl& url : event->mimeData()->urls())
    (url.isLocalFile() ? files : others)
        << (url.isLocalFile() ? url.toLocalFile() : url.toDisplayString());
  event->acceptProposedAction();
  // Whoever drops is still holding a drag: answer it first, then ask and open.
  QTimer::singleShot(0, this, [this, files, others] {
    if (!others.isEmpty())
      return complain(QStringLiteral("Only files of this machine are opened. Save what is behind "
                                     "the link first: %1")
                          .arg(others[0]));
    if (open_recording(files)) return;
    if (documents_->document().empty() && DocumentControl::is_one_mesh(files))
      return open_one_mesh(files[0]);
    documents_->drop(files);
  });
}

/// The first drag has told what the hint tells.
void MainWindow::fade_hint() {
  if (!std::exchange(hint_unread_, false) || !viewport_->shown(Layer::hint)) return;
  viewport_->fade_hint();
  if (auto* action = findChild<QAction*>(QStringLiteral("show_hint"))) action->setChecked(false);
}

}  // namespace sonde::ui
