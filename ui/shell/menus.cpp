// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/menus.hpp"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QRegularExpression>
#include <QToolBar>
#include <QUndoStack>
#include <QVBoxLayout>
#include <functional>

#include "ui/actions/document_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/actions/repairs_control.hpp"
#include "ui/actions/stiffness_control.hpp"
#include "ui/base/resources.hpp"
#include "ui/document/recent_files.hpp"
#include "ui/shell/command_palette.hpp"
#include "ui/shell/desk_menu.hpp"
#include "ui/shell/export_menu.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/manual.hpp"
#include "ui/shell/seeing_menu.hpp"
#include "ui/views/hint_view.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

using Slot = std::function<void(bool)>;

QAction* add(MainWindow& window, QMenu& menu, const char* object, const QString& text,
             const QKeySequence& key, const Slot& slot) {
  QAction* action = menu.addAction(text);
  action->setObjectName(QLatin1String(object));
  action->setShortcut(key);
  if (!key.isEmpty())
    action->setToolTip(QStringLiteral("%1 (%2)").arg(
        QString(text).remove('&').remove(QStringLiteral("…")), key.toString()));
  QObject::connect(action, &QAction::triggered, &window, slot);
  return action;
}

QAction* add_toggle(MainWindow& window, QMenu& menu, const char* object, const QString& text,
                    const QKeySequence& key, bool on, const Slot& slot) {
  QAction* action = add(window, menu, object, text, key, slot);
  action->setCheckable(true);
  action->setChecked(on);
  return action;
}

void add_layer(MainWindow& window, QMenu& menu, const char* object, const QString& text,
               const QKeySequence& key, Layer layer) {
  Viewport* view = &window.viewport();
  add_toggle(window, menu, object, text, key, view->shown(layer),
             [view, layer](bool on) { view->set_shown(layer, on); });
}

/// What an action is called, without the marks of menus.
QString name_of(const QAction& action) {
  static const QRegularExpression marks(QStringLiteral("&|…|:.*"));
  return QString(action.text()).remove(marks);
}

/// A row of the table of keys: what one presses, and what it does.
QString key_row(const QString& key, const QString& action) {
  return QStringLiteral("<tr><td style='padding-right:12px'><b>%1</b></td><td>%2</td></tr>")
      .arg(key.toHtmlEscaped(), action.toHtmlEscaped());
}

/// In columns: one would be higher than a screen.
void show_keys(MainWindow& window) {
  constexpr int columns = 3;
  QStringList rows;
  for (const auto& [key, action] : HintView::keys()) rows += key_row(key, action);
  for (const QAction* action : window.findChildren<QAction*>())
    if (!action->shortcut().isEmpty() && !action->objectName().isEmpty())
      rows += key_row(action->shortcut().toString(), name_of(*action));
  const int each = (rows.size() + columns - 1) / columns;
  QString cells;
  for (int from = 0; from < rows.size(); from += each)
    cells += QStringLiteral("<td style='padding-right:28px'><table>%1</table></td>")
                 .arg(rows.mid(from, each).join(QString()));
  QDialog box(&window);  // a message box would break the lines
  box.setWindowTitle(QStringLiteral("Mouse and keys"));
  box.setObjectName(QStringLiteral("keys_box"));
  auto* layout = new QVBoxLayout(&box);
  auto* table = new QLabel(QStringLiteral("<table><tr>%1</tr></table>").arg(cells), &box);
  table->setObjectName(QStringLiteral("keys_table"));
  layout->addWidget(table);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &box);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &box, &QDialog::reject);
  layout->addWidget(buttons);
  box.exec();
}

void show_about(MainWindow& window) {
  QMessageBox::about(
      &window, QStringLiteral("About Sonde"),
      QStringLiteral("<b>Sonde %1</b><p>Feel how two polygon soups touch: generalized penetration "
                     "depth and six-degree haptic rendering.</p><p>GPL-3.0-or-later.</p>")
          .arg(QStringLiteral(SONDE_VERSION)));
}

void open_manual(MainWindow& window) {
  const QString page = resource(QStringLiteral("docs/index.md"));
  if (page.isEmpty())
    return window.prompts().report_error(QStringLiteral("The manual is not installed."));
  auto* manual = window.findChild<Manual*>(QStringLiteral("manual"));
  if (!manual) manual = new Manual(QFileInfo(page).absolutePath(), &window);
  manual->show();
  manual->raise();
  manual->activateWindow();
}

/// Filled each time it is about to be seen.
void add_recent_menu(MainWindow& window, QMenu& menu) {
  QMenu* recent = menu.addMenu(QStringLiteral("Open &recent"));
  recent->setObjectName(QStringLiteral("recent"));
  MainWindow* w = &window;
  QObject::connect(recent, &QMenu::aboutToShow, w, [w, recent] {
    recent->clear();
    for (const QStringList& files : recent_files()) {
      QAction* action = recent->addAction(recent_name(files).replace('&', QStringLiteral("&&")));
      action->setStatusTip(files.join(QStringLiteral(", ")));
      QObject::connect(action, &QAction::triggered, w, [w, files] { w->open(files); });
    }
    if (recent->isEmpty()) recent->addAction(QStringLiteral("Nothing yet"))->setEnabled(false);
  });
}

void add_file_menu(MainWindow& window, QToolBar& bar) {
  QMenu& menu = *window.menuBar()->addMenu(QStringLiteral("&File"));
  MainWindow* w = &window;
  DocumentControl* documents = &window.documents();
  add(window, menu, "new", QStringLiteral("&New"), QKeySequence::New,
      [documents](bool) { documents->start_anew(); });
  bar.addAction(add(window, menu, "open_scene", QStringLiteral("&Open scene…"), QKeySequence::Open,
                    [documents](bool) { documents->ask_scene(); }));
  bar.addAction(add(window, menu, "open_meshes", QStringLiteral("Open two &meshes…"),
                    QKeySequence(QStringLiteral("Ctrl+M")),
                    [documents](bool) { documents->ask_meshes(); }));
  add_recent_menu(window, menu);
  menu.addSeparator();
  add(window, menu, "save", QStringLiteral("&Save"), QKeySequence::Save,
      [documents](bool) { documents->save(); });
  add(window, menu, "save_as", QStringLiteral("Save &as…"),
      QKeySequence(QStringLiteral("Ctrl+Shift+S")), [documents](bool) { documents->save_as(); });
  menu.addSeparator();
  add(window, menu, "open_tuning", QStringLiteral("Open a stability m&ap…"), {},
      [w](bool) { w->stiffness().ask_load(); });
  menu.addSeparator();
  bar.addAction(add(window, menu, "screenshot", QStringLiteral("&Screenshot…"),
                    QKeySequence(QStringLiteral("S")), [w](bool) { w->ask_picture(); }));
  add_export_menu(window, menu, window.exporter());
  menu.addSeparator();
  add(window, menu, "quit", QStringLiteral("&Quit"), QKeySequence::Quit, [w](bool) { w->close(); });
  bar.addSeparator();
}

/// "Undo: Reset" where there is a step, and "Undo" alone, not to be had, where there is none.
void name_with(QAction& action, const QString& name, QUndoStack& stack,
               void (QUndoStack::*text_changed)(const QString&),
               void (QUndoStack::*can_changed)(bool)) {
  action.setText(name);
  action.setEnabled(false);
  QObject::connect(&stack, text_changed, &action, [&action, name](const QString& step) {
    action.setText(step.isEmpty() ? name : QStringLiteral("%1: %2").arg(name, step));
  });
  QObject::connect(&stack, can_changed, &action, &QAction::setEnabled);
}

void add_edit_menu(MainWindow& window) {
  DocumentControl* documents = &window.documents();
  QUndoStack& stack = documents->document().stack();
  QMenu& menu = *window.menuBar()->addMenu(QStringLiteral("&Edit"));
  QAction* undo = add(window, menu, "undo", QStringLiteral("&Undo"), QKeySequence::Undo,
                      [&stack](bool) { stack.undo(); });
  QAction* redo = add(window, menu, "redo", QStringLiteral("&Redo"), QKeySequence::Redo,
                      [&stack](bool) { stack.redo(); });
  name_with(*undo, QStringLiteral("&Undo"), stack, &QUndoStack::undoTextChanged,
            &QUndoStack::canUndoChanged);
  name_with(*redo, QStringLiteral("&Redo"), stack, &QUndoStack::redoTextChanged,
            &QUndoStack::canRedoChanged);
  menu.addSeparator();
  const auto key = [](const char* text) { return QKeySequence(QLatin1String(text)); };
  add(window, menu, "copy_pose", QStringLiteral("&Copy pose"), key("Ctrl+C"),
      [documents](bool) { documents->copy_pose(); });
  add(window, menu, "copy_matrix", QStringLiteral("Copy pose as a &matrix"), key("Ctrl+Alt+C"),
      [documents](bool) { documents->copy_matrix(); });
  add(window, menu, "paste_pose", QStringLiteral("&Paste pose"), key("Ctrl+V"),
      [documents](bool) { documents->paste_pose(); });
  add(window, menu, "start_from_here", QStringLiteral("&Start from here"), key("Ctrl+R"),
      [documents](bool) { documents->start_from_here(); });
  menu.addSeparator();
  add(window, menu, "swap_bodies", QStringLiteral("S&wap probe and fixed body"),
      key("Ctrl+Shift+X"), [documents](bool) { documents->swap_bodies(); });
  add(window, menu, "bodies", QStringLiteral("&Units, axes and insides…"), {},
      [documents](bool) { documents->ask_bodies(); });
}

void add_probe_menu(MainWindow& window, QToolBar& bar) {
  QMenu& menu = *window.menuBar()->addMenu(QStringLiteral("&Probe"));
  MainWindow* w = &window;
  bar.addAction(add(window, menu, "reset", QStringLiteral("&Reset"),
                    QKeySequence(QStringLiteral("R")), [w](bool) { w->reset(); }));
  QAction* pause =
      add_toggle(window, menu, "pause", QStringLiteral("&Pause"),
                 QKeySequence(QStringLiteral("Space")), false, [w](bool on) { w->set_paused(on); });
  QObject::connect(w, &MainWindow::paused_changed, pause, &QAction::setChecked);
  bar.addAction(pause);
  QAction* force = add_toggle(window, menu, "force", QStringLiteral("&Force"),
                              QKeySequence(QStringLiteral("Ctrl+Space")), true,
                              [w](bool on) { w->set_force(on); });
  QObject::connect(w, &MainWindow::force_changed, force, &QAction::setChecked);
  bar.addAction(force);
  add(window, menu, "switch_gains", QStringLiteral("&Gains A/B"), QKeySequence(QStringLiteral("B")),
      [w](bool) { w->stiffness().switch_gains(); });
  bar.addSeparator();
}

void add_history_menu(MainWindow& window) {
  QMenu& menu = *window.menuBar()->addMenu(QStringLiteral("&Time"));
  HistoryControl* history = &window.history();
  MainWindow* w = &window;
  const auto key = [](const char* text) { return QKeySequence(QLatin1String(text)); };
  add(window, menu, "open_recording", QStringLiteral("&Open a recording…"), {},
      [history](bool) { history->ask_recording(); });
  add(window, menu, "record", QStringLiteral("&Record or stop"), key("Ctrl+Shift+R"),
      [history](bool) { history->set_recording(!history->recorder().recording()); });
  menu.addSeparator();
  add(window, menu, "play_back", QStringLiteral("&Play or hold the kept ticks"), key("P"),
      [history](bool) { history->play(!history->playback().playing()); });
  add(window, menu, "step_back", QStringLiteral("One tick &back"), key(","),
      [history](bool) { history->step(-1); });
  add(window, menu, "step_on", QStringLiteral("One tick o&n"), key("."),
      [history](bool) { history->step(1); });
  add(window, menu, "go_live", QStringLiteral("Back to &live"), key("End"),
      [history](bool) { history->go_live(); });
  menu.addSeparator();
  add(window, menu, "run_again", QStringLiteral("Run again with the &gains of now"), {},
      [history, w](bool) {
        if (w->session()) history->run_again(Method::pdg, w->session()->coupling());
      });
  add(window, menu, "run_both", QStringLiteral("Run again with &A and B"), {}, [history, w](bool) {
    const GainSets& sets = w->stiffness().sets();
    if (w->session()) history->run_both(sets.gains(0), sets.gains(1));
  });
  add(window, menu, "run_again_pdt", QStringLiteral("Run again without turns (PD_&t)"), {},
      [history](bool) { history->run_again(Method::pdt, {}); });
}

void add_mended(MainWindow& window, QMenu& menu, QToolBar& tools) {
  RepairsControl* repairs = &window.repairs();
  const QAction* next =
      add(window, menu, "next_mended", QStringLiteral("&Next mended place"),
          QKeySequence(QStringLiteral("N")), [repairs](bool) { repairs->show_next(); });
  repairs->bar().set_key(next->shortcut().toString());
  QAction* bar = add_toggle(window, menu, "mended_bar", QStringLiteral("What was &mended"), {},
                            !repairs->away(), [repairs](bool on) { repairs->set_away(!on); });
  QObject::connect(repairs, &RepairsControl::away_changed, bar,
                   [bar](bool away) { bar->setChecked(!away); });
  bar->setToolTip(QStringLiteral("What was mended: a line for each body, with what can be done"));
  repairs->notice().set_action(bar);
  tools.addWidget(&repairs->notice())->setObjectName(QStringLiteral("mended_notice"));
}

/// What is drawn over the bodies, each by a figure or a letter.
void add_overlay_menu(MainWindow& window, QMenu& view) {
  QMenu& menu = *view.addMenu(QStringLiteral("&Overlays"));
  const auto layer = [&](const char* object, const char* text, const char* key, Layer what) {
    add_layer(window, menu, object, QString::fromUtf8(text), QKeySequence(QLatin1String(key)),
              what);
  };
  layer("show_ghost", "Separated probe, as held", "1", Layer::ghost);
  layer("show_screw", "Separation as a screw", "2", Layer::screw);
  layer("show_contacts", "Contacts", "3", Layer::contacts);
  layer("show_wrench", "Force and torque", "4", Layer::wrench);
  layer("show_nearest", "Nearest way out", "5", Layer::nearest);
  layer("show_straight", "Nearest way out without a turn (PD_t)", "6", Layer::straight);
  layer("show_bound", "Witness of the lower bound", "7", Layer::bound);
  layer("show_clearance", "Clearance, and where it is", "8", Layer::clearance);
  layer("show_stiffness", "Felt stiffness", "9", Layer::stiffness);
  layer("show_defects", "Holes and flipped faces", "D", Layer::defects);
  layer("show_mended", "Closed openings, in their colour", "", Layer::mended);
}

/// Small enough for the least screen: what is many of a kind is in a menu of its own.
void add_view_menu(MainWindow& window, QToolBar& bar) {
  QMenu& menu = *window.menuBar()->addMenu(QStringLiteral("&View"));
  MainWindow* w = &window;
  const auto key = [](const char* text) { return QKeySequence(QLatin1String(text)); };
  bar.addAction(add(window, menu, "fit", QStringLiteral("&Fit"), key("F"),
                    [w](bool) { w->viewport().fit(); }));
  add_toggle(window, menu, "parallel", QStringLiteral("&Parallel projection"), key("O"), false,
             [w](bool on) { w->viewport().set_parallel(on); });
  add_camera_actions(window, menu, window.seeing());
  menu.addSeparator();
  add_overlay_menu(window, menu);
  add_layer(window, menu, "show_handles", QStringLiteral("Handles"), key("G"), Layer::handles);
  add_toggle(window, menu, "local_handles", QStringLiteral("Handles along the probe's axes"),
             key("L"), false, [w](bool on) { w->viewport().set_handles_local(on); });
  add_layer(window, menu, "show_hint", QStringLiteral("Hint and legend"), key("H"), Layer::hint);
  add_layer(window, menu, "show_grid", QStringLiteral("Grid on the ground"), key("Shift+G"),
            Layer::grid);
  bar.addAction(add_toggle(window, menu, "trail", QStringLiteral("&Trail"), key("T"), false,
                           [w](bool on) { w->viewport().set_shown(Layer::trail, on); }));
  add_toggle(window, menu, "swing", QStringLiteral("S&wing the separated probe"), key("W"), false,
             [w](bool on) { w->set_swing(on); });
  menu.addSeparator();
  add_mended(window, menu, bar);
  menu.addSeparator();
  add_desk_menu(window, menu);
}

void add_help_menu(MainWindow& window) {
  QMenu& menu = *window.menuBar()->addMenu(QStringLiteral("&Help"));
  MainWindow* w = &window;
  add(window, menu, "manual", QStringLiteral("&Manual"), QKeySequence::HelpContents,
      [w](bool) { open_manual(*w); });
  add(window, menu, "keys", QStringLiteral("Mouse and &keys"), QKeySequence(QStringLiteral("F2")),
      [w](bool) { show_keys(*w); });
  add(window, menu, "find_command", QStringLiteral("&Find a command…"),
      QKeySequence(QStringLiteral("Ctrl+Shift+P")), [w](bool) { find_command(*w->menuBar(), *w); });
  add(window, menu, "about", QStringLiteral("&About Sonde"), {}, [w](bool) { show_about(*w); });
}

}  // namespace

void add_menus(MainWindow& window) {
  QToolBar* bar = window.addToolBar(QStringLiteral("Actions"));
  bar->setObjectName(QStringLiteral("actions_bar"));
  bar->setMovable(false);
  bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
  add_file_menu(window, *bar);
  add_edit_menu(window);
  add_probe_menu(window, *bar);
  add_history_menu(window);
  add_view_menu(window, *bar);
  add_seeing_menu(window, *window.menuBar(), window.seeing());
  add_help_menu(window);
}

}  // namespace sonde::ui
