// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.hpp"

#include <vtkPolyData.h>

#include <QAction>
#include <QFileInfo>
#include <QImage>
#include <QPixmap>
#include <QSaveFile>
#include <QStatusBar>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/error.hpp"
#include "ui/actions/accuracy_control.hpp"
#include "ui/actions/clash_control.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/export_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/opener.hpp"
#include "ui/actions/parts_control.hpp"
#include "ui/actions/repairs_control.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/actions/snap_control.hpp"
#include "ui/actions/stiffness_control.hpp"
#include "ui/actions/way_in_control.hpp"
#include "ui/base/format.hpp"
#include "ui/base/resources.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/devices/mouse_probe.hpp"
#include "ui/panels/coupling_panel.hpp"
#include "ui/panels/device_panel.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/pose_panel.hpp"
#include "ui/panels/readout_panel.hpp"
#include "ui/shell/search_control.hpp"
#include "ui/shell/side_bar.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/shell/status_text.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr qint64 numbers_ms = 120;  // faster than that nobody reads
constexpr double swing_seconds = 1.6;

}  // namespace

MainWindow::~MainWindow() {
  stiffness_->keep_gains();
  documents_->disconnect();    // what goes now is not shown any more
  force_log_.end();            // the session ends with the window
  accuracy_->attach(nullptr);  // its dock is hidden after that
}

void MainWindow::show_document() {
  Document& document = documents_->document();
  const QString name = QString::fromStdString(document.content().scene.name);
  setWindowTitle(document.empty() ? QStringLiteral("Sonde")
                                  : QStringLiteral("%1[*] – Sonde").arg(name));
  setWindowModified(document.modified());
  seeing_->show_saved();
  parts_->show_document();
  accuracy_->show_knob();
}

/// What a box says is gone with the box.
void MainWindow::complain(const QString& reason) {
  log_->add(reason);
  prompts_.report_error(reason);
}

void MainWindow::open(const QStringList& files, std::optional<double> unit) {
  statusBar()->showMessage(QStringLiteral("Opening %1 …").arg(QFileInfo(files.value(0)).fileName()),
                           4000);
  if (open_recording(files)) return;
  if (DocumentControl::is_one_mesh(files)) return open_one_mesh(files[0]);
  documents_->open(files, unit);
}

/// The other one is asked for once it is known that this one can be read.
void MainWindow::open_one_mesh(const QString& file) {
  opener_->check_mesh(file, [this, file] {
    if (!documents_->ask_meshes(file)) emit open_failed({});
  });
}

/// False where it is none.
bool MainWindow::open_recording(const QStringList& files) {
  if (files.size() != 1 || !is_recording(files[0].toStdString())) return false;
  history_->open_recording(files[0]);
  return true;
}

void MainWindow::ask_path() {
  const QString file = prompts_.ask_path();
  if (!file.isEmpty()) try {
      remember_folder_of(file);
      devices_->choose(path_source(file.toStdString()));
    } catch (const InputError& bad) {
      complain(QString::fromUtf8(bad.what()));
    }
  show_device();
}

void MainWindow::show_start_page() {
  clear_desk();
  start_page_->present();
}

void MainWindow::show_nothing() {
  stiffness_->keep_gains();
  devices_->attach(nullptr);
  documents_->attach(nullptr);
  stiffness_->attach(nullptr);
  history_->attach(nullptr);
  seeing_->attach(nullptr);
  accuracy_->attach(nullptr);
  exporter_->attach(nullptr);
  repairs_->attach(nullptr);
  parts_->attach(nullptr);
  way_in_->attach(nullptr);
  snap_->attach(nullptr);
  clash_->attach(nullptr);
  force_log_.end();
  forget_shown();
  search_->forget();
  endings_.add(std::move(drawn_.session));
  drawn_ = {};
  show_start_page();
}

void MainWindow::show_session(DrawnSession drawn, bool same_document) {
  stiffness_->keep_gains();  // of what was open
  accuracy_->attach(nullptr);
  statusBar()->clearMessage();
  start_page_->hide();
  lay_desk();
  // It lives until nothing below refers to it any more.
  std::unique_ptr<Session> before = std::move(drawn_.session);
  drawn_ = std::move(drawn);
  documents_->attach(session());
  force_log_.end();
  Session& now = *drawn_.session;
  endings_.expect(before.get());
  now.wait_for(endings_.unended());
  now.set_force(force_);  // what Esc took away stays away
  forget_shown();
  search_->forget();
  history_->attach(session());
  repairs_->attach(&now, same_document);  // before: its bar takes room from the view
  viewport_->show_bodies(drawn_.bodies, same_document);
  seeing_->attach(&now);
  exporter_->attach(&drawn_);
  if (same_document)
    coupling_panel_->apply(documents_->document().content().scene.coupling);
  else
    documents_->opened(now), coupling_panel_->take(now.coupling());
  parts_->attach(&now);
  way_in_->attach(&now, same_document);
  snap_->attach(&now);
  clash_->attach(&now, same_document);
  stiffness_->attach(session(), same_document);
  accuracy_->attach(session());
  // Last: it may have something to report, and a frame be drawn meanwhile.
  if (!same_document) suited_.reset();
  devices_->attach(session());
  endings_.add(std::move(before));
  suit_gains();
  const Session& open = *session();  // by now it may be another
  readout_->take(open.loaded().pair);
  const QString name = QString::fromStdString(open.loaded().name);
  pose_panel_->suggest_unit(LengthUnit(open.fixed().mass.radius).name());
  constexpr double step = 0.01;  // of the probe's radius, a key
  if (!same_document) pose_panel_->suggest_step(round_down_125(step * open.probe().mass.radius));
  log_->add(
      QStringLiteral("Opened %1.   %2").arg(name, natures(session()->probe(), session()->fixed())));
  // As it is by now: that may have taken a while, and Esc works meanwhile.
  emit paused_changed(session()->paused());
  emit force_changed(session()->force_on());
  on_frame();
  emit opened();
}

/// What holds the probe, or how, has changed: the mouse begins where the probe is.
void MainWindow::show_holder() {
  if (session()) mouse_->take(session()->probe().mass, session()->device_pose());
  device_panel_->show_choices(devices_->choices(), devices_->source());
  device_panel_->show_settings(devices_->source(), devices_->settings(),
                               devices_->settings_from_scene());
  device_panel_->show_servo(devices_->servo());
  const auto* simulating = std::get_if<SimulatedSource>(&devices_->source());
  // A connected device by its serial number or port, a simulated one by its profile.
  std::string name = settings_name_of(devices_->source());
  if (name.empty()) name = name_of(devices_->source());
  const auto* connected = std::get_if<ConnectedSource>(&devices_->source());
  const bool feels = connected && (connected->kind == DeviceKind::force_device ||
                                   connected->kind == DeviceKind::arm);
  set_felt(feels);
  stiffness_->set_holder({simulating ? std::optional(simulating->profile) : std::nullopt, name,
                          feels ? QString::fromStdString(connected->name) : QString(),
                          feels ? devices_->model() : std::string()});
  show_device();
  suit_gains();
}

void MainWindow::set_device_pose(const Pose& X_FM) {
  if (!session()) return;
  session()->set_device_pose(X_FM);
  mouse_->take(session()->probe().mass, X_FM);
}

/// What was kept is looked at in a pause, so that going on is going on live.
void MainWindow::set_paused(bool paused) {
  if (!paused) history_->leave();
  pause(paused);
}

void MainWindow::pause(bool paused) {
  if (session()) session()->set_paused(paused);
  if (session() && !history_->looking_back())
    mouse_->take(session()->probe().mass, session()->device_pose());
  emit paused_changed(session() && paused);
}

void MainWindow::set_force(bool on) {
  force_ = on;  // also while the first pair is being read
  if (session()) session()->set_force(on);
  if (!on) endings_.stop_force();
  emit force_changed(on);
}

void MainWindow::reset() {
  if (!session()) return;
  const Pose before = session()->device_pose();
  place(session()->loaded().start);
  documents_->moved_from(before, QStringLiteral("Reset"), false);
}

void MainWindow::place(const Pose& X_FM) {
  force_log_.end();
  history_->leave();
  session()->place(X_FM);
  mouse_->take(session()->probe().mass, X_FM);
  viewport_->find_probe(X_FM);
  forget_shown();
  emit paused_changed(false);
}

void MainWindow::on_frame() {
  for (SideBar* bar : {left_, right_}) bar->hold_widths(!isVisible()), bar->note_widths();
  const ViewAxes view = viewport_->camera().axes();
  Mat3 R_FV;
  R_FV << view.right, view.up, view.towards;
  devices_->frame(Quat(R_FV));
  if (clock_.elapsed() >= device_due_) show_device();
  if (!session()) return;
  if (session()->placing())
    status_.show_happening(QStringLiteral("Searching the way out at the new place …"));
  stiffness_->frame(clock_.elapsed());
  history_->frame(clock_.elapsed());
  viewport_->set_force_note(history_->looking_back() ? ForceNote{} : stiffness_->note());
  draw_if_changed();
  frame_rate_.frame();
  if (!shown_) return;
  const qint64 now = clock_.elapsed();
  search_->frame(*session(), shown_->separation, now, wants_search());
  if (now >= numbers_due_) {
    numbers_due_ = now + numbers_ms;
    show_numbers();
  }
}

void MainWindow::show_kept(const std::shared_ptr<KeptTicks>& ticks, double time) {
  history_->show_kept(ticks, time);
}

/// What there is to show: of the servo, or of what was kept.
std::optional<Instant> MainWindow::newest() {
  if (history_->looking_back()) {
    std::optional<Instant> then = history_->instant();
    if (then) measure_clearance(*then);
    return then;
  }
  const Snapshot* now = session()->latest();
  if (!now) return {};
  const auto& searched = search_->newest();
  Instant live = instant_of(*now, searched ? &*searched : nullptr, true);
  live.snapshot.paused = session()->paused();
  measure_clearance(live);
  if (live.clearance) history_->add(*live.clearance);
  return live;
}

/// Where it is shown, and the probe is free.
void MainWindow::measure_clearance(Instant& now) {
  const Separation& s = now.snapshot.separation;
  const bool wanted =
      viewport_->shown(Layer::clearance) || readout_->isVisible() || history_->plots().isVisible();
  if (wanted && s.status == Status::separated) now.clearance = session()->clearance(s.device);
}

void MainWindow::draw_if_changed() {
  const std::optional<Instant> next = newest();
  if (!next) return;
  const bool changed = !instant_ || !same_picture(*instant_, *next);
  instant_ = next;
  shown_ = next->snapshot;
  seeing_->frame(*shown_);
  accuracy_->frame(*shown_, clock_.elapsed());
  const bool swings = swing_ && shown_->separation.status == Status::penetrating;
  if (!changed && !swings && !viewport_->dirty()) return;
  const double turn = double(clock_.elapsed()) / 1000 / swing_seconds;
  const double swing = swings ? 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turn) : 1;
  viewport_->draw(*next, swing);
  ++frames_;
}

/// Whether anything shows or keeps what the searches beside the ticks find.
bool MainWindow::wants_search() const {
  return readout_->isVisible() || history_->plots().isVisible() || accuracy_->is_on_show() ||
         history_->recorder().recording() || search_->is_drawn();
}

void MainWindow::show_numbers() {
  readout_->show_numbers(*instant_);
  const PlotState course = history_->course();
  readout_->show_course(course.kept, course.time);
  seeing_->show_numbers(*shown_);
  pose_panel_->show_pose(instant_->live ? session()->device_pose() : shown_->separation.device);
  show_status();
}

void MainWindow::show_status() {
  const Snapshot& s = *shown_;
  QString happens = happening(*instant_, LengthUnit(session()->probe().mass.radius));
  if (const auto& searched = search_->newest(); instant_->live && searched)
    log_->add(QString::fromUtf8(words(way_out(s.separation, *searched))));
  if (const QString fault = force_log_.recent(s.time); instant_->live && !fault.isEmpty())
    happens += QLatin1Char(' ') + fault;
  status_.show_happening(
      QStringLiteral("%1   %2").arg(happens, natures(session()->probe(), session()->fixed())));
  status_.show_rates(*instant_, *session(), frame_rate_.at(clock_.elapsed()),
                     viewport_->simplified());
}

/// Also with nothing open: what is plugged in shows at once.
void MainWindow::show_device() {
  device_due_ = clock_.elapsed() + numbers_ms;
  const InputSource& source = devices_->source();
  const SourceReport report = devices_->report();
  device_panel_->show_choices(devices_->choices(), source);
  device_panel_->show_report(source, report);
  device_panel_->show_energy(shown_ ? shown_->hand.energy : HandEnergy{});
  device_panel_->show_real_time(session() ? session()->timing().real_time : RealTime{});
  status_.show_source(source, report);
}

bool MainWindow::save_picture(const QString& file) {
  if (instant_) viewport_->draw_in_full(*instant_, 1);
  const QImage image = grab().toImage();
  QSaveFile out(file);
  if (out.open(QIODevice::WriteOnly) && image.save(&out, "PNG") && out.commit()) {
    statusBar()->showMessage(QStringLiteral("Saved %1").arg(file), 4000);
    return true;
  }
  complain(QStringLiteral("%1: %2").arg(file, out.errorString()));
  return false;
}

void MainWindow::ask_picture() {
  const QString file = prompts_.ask_picture();
  if (file.isEmpty()) return;
  remember_folder_of(file);
  save_picture(file);
}

}  // namespace sonde::ui
