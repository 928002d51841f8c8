// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.hpp"

#include <vtkPolyData.h>

#include <QAction>
#include <QApplication>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QMimeData>
#include <QPixmap>
#include <QSaveFile>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/error.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/export_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/opener.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/actions/stiffness_control.hpp"
#include "ui/base/elided_label.hpp"
#include "ui/base/format.hpp"
#include "ui/base/resources.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/devices/mouse_probe.hpp"
#include "ui/panels/coupling_panel.hpp"
#include "ui/panels/device_panel.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/pose_panel.hpp"
#include "ui/panels/readout_panel.hpp"
#include "ui/panels/stiffness_panel.hpp"
#include "ui/shell/menus.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/shell/status_text.hpp"
#include "ui/shell/timing_text.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr int frame_ms = 16;
constexpr qint64 numbers_ms = 120;  // faster than that nobody reads
constexpr qint64 search_ms = 100;   // it shares the machine with the servo
constexpr double swing_seconds = 1.6;

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      prompts_(dialogs(*this)),
      opener_(std::make_unique<Opener>(*this, prompts_)),
      documents_(std::make_unique<DocumentControl>(*opener_, prompts_, document_view())),
      viewport_(new Viewport(this)),
      mouse_(new MouseProbe(*viewport_, this)),
      coupling_panel_(new CouplingPanel(documents_->document().stack(), this)),
      readout_(new ReadoutPanel(this)),
      log_(new LogPanel(this)),
      pose_panel_(new PosePanel(this)),
      start_page_(new StartPage(viewport_)),
      devices_(std::make_unique<DeviceControl>(device_settings_folder(), device_profile_folders())),
      device_panel_(new DevicePanel(this)),
      stiffness_(new StiffnessControl(device_profile_folders(), *coupling_panel_,
                                      documents_->document().stack(), prompts_, *this)),
      what_happens_(new ElidedLabel(this)),
      device_status_(new QLabel(this)),
      rates_(new QLabel(this)),
      escape_([this] { set_force(false); }) {
  setObjectName(QStringLiteral("main_window"));
  setWindowTitle(QStringLiteral("Sonde"));
  setAcceptDrops(true);
  setCentralWidget(viewport_);
  addDockWidget(Qt::LeftDockWidgetArea, coupling_panel_);
  tabifyDockWidget(coupling_panel_, device_panel_);
  tabifyDockWidget(coupling_panel_, pose_panel_);
  start_page_->hide();
  coupling_panel_->raise();
  addDockWidget(Qt::RightDockWidgetArea, readout_);
  tabifyDockWidget(readout_, &stiffness_->panel());
  seeing_ = new SeeingControl(*viewport_, *documents_, *this, *readout_);
  exporter_ = new ExportControl(*viewport_, *this);
  connect_export();
  seeing_->say = [this](const QString& what) { statusBar()->showMessage(what, 4000); };
  readout_->raise();
  addDockWidget(Qt::BottomDockWidgetArea, log_);
  log_->hide();
  connect(statusBar(), &QStatusBar::messageChanged, log_, &LogPanel::add);
  what_happens_->setObjectName(QStringLiteral("what_happens"));
  rates_->setObjectName(QStringLiteral("rates"));
  device_status_->setObjectName(QStringLiteral("device_status"));
  device_status_->setTextFormat(Qt::PlainText);  // a device names itself
  statusBar()->addWidget(what_happens_, 1);
  statusBar()->addPermanentWidget(device_status_);
  statusBar()->addPermanentWidget(rates_);
  add_history();
  add_menus(*this);
  mouse_->moved = [this](const Pose& pose) {
    if (session() && !history_->looking_back()) session()->set_device_pose(pose);
  };
  coupling_panel_->changed = [this](const Coupling& coupling) {
    if (session()) session()->set_coupling(coupling);
    documents_->set_coupling(coupling);
    viewport_->set_coupling(coupling);
    stiffness_->show_gains(coupling);
  };
  coupling_panel_->mouse_gain_changed = [this](double gain) { mouse_->set_gain(gain); };
  mouse_->settled = [this](const Pose& before, bool one_of_many) {
    if (history_->looking_back()) return;
    documents_->moved_from(before, one_of_many ? QStringLiteral("Nudge") : QStringLiteral("Drag"),
                           one_of_many);
  };
  connect_devices();
  connect_documents();
  stiffness_->ticked = [this](const Snapshot& tick) {
    log_->add(force_log_.add(tick));
    history_->add(tick);
  };
  stiffness_->failed = [this](const QString& reason) { log_->add(reason); };
  opener_->ready = [this](DrawnSession drawn) { show_session(std::move(drawn)); };
  opener_->failed = [this](const QString& reason) {
    log_->add(reason);
    emit open_failed(reason);
  };
  connect(&frame_timer_, &QTimer::timeout, this, &MainWindow::on_frame);
  frame_timer_.setTimerType(Qt::PreciseTimer);
  frame_timer_.start(frame_ms);
  clock_.start();
  restore_window();
  viewport_->canvas()->setFocus();
}

MainWindow::~MainWindow() {
  documents_->changed = nullptr;  // what goes now is not shown any more
  force_log_.end();               // the session ends with the window
}

void MainWindow::connect_devices() {
  devices_->changed = [this] { show_holder(); };
  devices_->report_error = [this](const QString& reason) { complain(reason); };
  device_panel_->chosen = [this](const InputSource& source) { devices_->choose(source); };
  device_panel_->path_wanted = [this] { ask_path(); };
  device_panel_->settings_changed = [this](const DeviceSettings& settings) {
    documents_->set_device_settings(settings);
  };
  device_panel_->led_switched = [this](bool on) { devices_->set_led(on); };
}

void MainWindow::add_history() {
  history_ = new HistoryControl(
      *opener_, prompts_, *this,
      {.session = [this] { return session(); },
       .scene = [this] { return documents_->document().content().scene; },
       .may_leave = [this] { return documents_->may_leave(); },
       .show = [this](DrawnSession drawn) { show_session(std::move(drawn)); },
       .pause = [this](bool on) { pause(on); },
       .say = [this](const QString& what) { statusBar()->showMessage(what, 4000); }});
  addDockWidget(Qt::BottomDockWidgetArea, &history_->timeline());
  addDockWidget(Qt::BottomDockWidgetArea, &history_->plots());
  tabifyDockWidget(log_, &history_->plots());
  history_->plots().hide();
}

void MainWindow::connect_export() {
  exporter_->snapshot = [this] { return shown_ ? &*shown_ : nullptr; };
  exporter_->searched = [this] {
    return instant_ && instant_->searched ? &*instant_->searched : nullptr;
  };
  exporter_->say = [this](const QString& what) { statusBar()->showMessage(what, 4000); };
  exporter_->fail = [this](const QString& reason) { complain(reason); };
}

DocumentView MainWindow::document_view() {
  return {.session = [this] { return session(); },
          .show = [this](DrawnSession drawn, bool same) { show_session(std::move(drawn), same); },
          .empty = [this] { show_nothing(); },
          .place = [this](const Pose& pose) { place(pose); },
          .show_coupling = [this](const Coupling& gains) { coupling_panel_->apply(gains); },
          .show_device_settings =
              [this](const DeviceSettings& settings) { devices_->set_settings(settings); },
          .camera = [this] { return viewport_->place(); },
          .look = [this](const CameraPlace& place) { viewport_->look(place); },
          .say = [this](const QString& what) { statusBar()->showMessage(what, 4000); }};
}

void MainWindow::connect_documents() {
  DocumentControl* documents = documents_.get();
  documents->changed = [this] { show_document(); };
  pose_panel_->placed = [documents](const Pose& pose) {
    documents->place(pose, QStringLiteral("Place the probe"));
  };
  pose_panel_->copy_wanted = [documents] { documents->copy_pose(); };
  pose_panel_->paste_wanted = [documents] { documents->paste_pose(); };
  pose_panel_->start_wanted = [documents] { documents->start_from_here(); };
  pose_panel_->swap_wanted = [documents] { documents->swap_bodies(); };
  start_page_->scene_wanted = [documents] { documents->ask_scene(); };
  start_page_->meshes_wanted = [documents] { documents->ask_meshes(); };
  start_page_->chosen = [this](const QStringList& files) { open(files); };
}

void MainWindow::show_document() {
  Document& document = documents_->document();
  const QString name = QString::fromStdString(document.content().scene.name);
  setWindowTitle(document.empty() ? QStringLiteral("Sonde")
                                  : QStringLiteral("%1[*] – Sonde").arg(name));
  setWindowModified(document.modified());
  seeing_->show_saved();
}

/// What a box says is gone with the box.
void MainWindow::complain(const QString& reason) {
  log_->add(reason);
  prompts_.report_error(reason);
}

/// The first window leaves room for its frame and for the desktop's own bars.
void MainWindow::restore_window() {
  constexpr double part = 0.9;
  resize((QApplication::primaryScreen()->availableSize() * part).boundedTo({1440, 900}));
  resizeDocks({coupling_panel_, readout_}, {300, 345}, Qt::Horizontal);
  const QSettings settings;
  restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("docks")).toByteArray());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!documents_->may_leave()) return event->ignore();
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("docks"), saveState());
  QMainWindow::closeEvent(event);
}

void MainWindow::open(const QStringList& files, std::optional<double> unit) {
  statusBar()->showMessage(QStringLiteral("Opening %1 …").arg(QFileInfo(files.value(0)).fileName()),
                           4000);
  if (files.size() == 1 && is_recording(files[0].toStdString()))
    history_->open_recording(files[0]);
  else
    documents_->open(files, unit);
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

void MainWindow::show_start_page() { start_page_->present(); }

void MainWindow::show_nothing() {
  devices_->attach(nullptr);
  stiffness_->attach(nullptr);
  history_->attach(nullptr);
  seeing_->attach(nullptr);
  exporter_->attach(nullptr);
  force_log_.end();
  forget_shown();
  searched_.reset();
  drawn_ = {};
  show_start_page();
}

void MainWindow::show_session(DrawnSession drawn, bool same_document) {
  statusBar()->clearMessage();
  start_page_->hide();
  drawn_ = std::move(drawn);
  force_log_.end();
  Session& now = *drawn_.session;
  now.set_force(force_);  // what Esc took away stays away
  forget_shown();
  searched_.reset();
  history_->attach(session());
  viewport_->show_session(drawn_, same_document);
  seeing_->attach(&now);
  exporter_->attach(&drawn_);
  if (same_document)
    coupling_panel_->apply(documents_->document().content().scene.coupling);
  else
    documents_->opened(now), coupling_panel_->take(now.coupling());
  stiffness_->attach(session(), same_document);
  // Last: it may have something to report, and a frame be drawn meanwhile.
  devices_->attach(session());
  const Session& open = *session();  // by now it may be another
  readout_->take(open.probe().mass, open.probe().solid || open.fixed().solid);
  const QString name = QString::fromStdString(open.loaded().name);
  pose_panel_->suggest_unit(LengthUnit(open.fixed().mass.radius).name());
  log_->add(QStringLiteral("LoadedScene %1.   %2")
                .arg(name, natures(session()->probe(), session()->fixed())));
  // As it is by now: that may have taken a while, and Esc works meanwhile.
  emit paused_changed(session()->paused());
  emit force_changed(session()->force_on());
  on_frame();
  emit opened();
}

void MainWindow::show_device_dock() {
  device_panel_->show();
  device_panel_->raise();
}

/// What holds the probe, or how, has changed: the mouse begins where the probe is.
void MainWindow::show_holder() {
  if (session()) mouse_->take(session()->probe().mass, session()->device_pose());
  device_panel_->show_choices(devices_->choices(), devices_->source());
  device_panel_->show_settings(devices_->source(), devices_->settings(),
                               devices_->settings_from_scene());
  device_panel_->show_servo(devices_->servo());
  const auto* simulating = std::get_if<SimulatedSource>(&devices_->source());
  stiffness_->set_device(simulating ? std::optional(simulating->profile) : std::nullopt);
  show_device();
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
  forget_shown();
  emit paused_changed(false);
}

void MainWindow::on_frame() {
  const ViewAxes view = viewport_->camera().axes();
  Mat3 R_FV;
  R_FV << view.right, view.up, view.towards;
  devices_->frame(Quat(R_FV));
  if (clock_.elapsed() >= device_due_) show_device();
  if (!session()) return;
  stiffness_->frame(clock_.elapsed());
  history_->frame(clock_.elapsed());
  draw_if_changed();
  ++rate_frames_;
  if (!shown_) return;
  const qint64 now = clock_.elapsed();
  ask_search();
  if (now >= numbers_due_) {
    numbers_due_ = now + numbers_ms;
    show_numbers();
  }
}

/// What there is to show: of the servo, or of what was kept.
std::optional<Instant> MainWindow::newest() {
  if (history_->looking_back()) return history_->instant();
  const Snapshot* now = session()->latest();
  if (!now) return {};
  Instant live{.snapshot = *now, .searched = searched_};
  live.snapshot.paused = session()->paused();
  return live;
}

void MainWindow::draw_if_changed() {
  const std::optional<Instant> next = newest();
  if (!next) return;
  const bool changed = !instant_ || !same_picture(*instant_, *next);
  instant_ = next;
  shown_ = next->snapshot;
  readout_->sample(*next);
  seeing_->frame(*shown_);
  const bool swings = swing_ && shown_->separation.status == Status::penetrating;
  if (!changed && !swings && !viewport_->dirty()) return;
  const double turn = double(clock_.elapsed()) / 1000 / swing_seconds;
  const double swing = swings ? 0.5 - 0.5 * std::cos(2 * std::numbers::pi * turn) : 1;
  viewport_->draw(*next, swing);
  ++frames_;
}

/// PD_t and the lower bound take longer than a tick: in their own thread, and only while shown. As
/// long as the probe moves, for a tenth of the time: the servo and the picture need the machine.
void MainWindow::ask_search() {
  if (!readout_->isVisible() || session()->paused()) return;
  const qint64 now = clock_.elapsed();
  const Pose& device = shown_->separation.device;
  if (!same_pose(device, search_pose_)) {
    search_pose_ = device;
    rest_since_ = now;
  }
  if (const auto result = session()->searched()) {
    const bool drawn = viewport_->shown(Layer::nearest) || viewport_->shown(Layer::straight) ||
                       viewport_->shown(Layer::bound);
    if (drawn && !(searched_ && same_pose(searched_->device, result->device)))
      viewport_->invalidate();
    searched_ = result;
    history_->add(*result);
    search_due_ = search_asked_ + std::max(search_ms, qint64(1e-2 * result->time_us));
  }
  const bool rests = now - rest_since_ > search_ms && !same_pose(device, asked_pose_);
  if (!rests && now < search_due_) return;
  if (searched_ && same_pose(searched_->device, device)) return;
  session()->ask_search(device);
  asked_pose_ = device;
  search_asked_ = now;
  search_due_ = now + 10 * search_ms;
}

void MainWindow::show_numbers() {
  const qint64 now = clock_.elapsed();
  if (now - rate_since_ >= 500) {
    frame_rate_ = double(rate_frames_) * 1000 / double(now - rate_since_);
    rate_since_ = now;
    rate_frames_ = 0;
  }
  readout_->show_numbers(*instant_);
  seeing_->show_numbers(*shown_);
  pose_panel_->show_pose(instant_->live ? session()->device_pose() : shown_->separation.device);
  show_status();
}

void MainWindow::show_status() {
  const Snapshot& s = *shown_;
  QString happens = happening(*instant_);
  if (instant_->live && searched_)
    log_->add(QString::fromUtf8(words(way_out(s.separation, *searched_))));
  if (const QString fault = force_log_.recent(s.time); instant_->live && !fault.isEmpty())
    happens += QLatin1Char(' ') + fault;
  what_happens_->show_text(
      QStringLiteral("%1   %2").arg(happens, natures(session()->probe(), session()->fixed())));
  rates_->setToolTip(timing_text(session()->timing()));
  rates_->setText(QStringLiteral("servo %1 Hz, tick %2 µs, view %3 frames/s")
                      .arg(s.paused ? 0 : s.rate_hz, 0, 'f', 0)
                      .arg(s.tick_us, 0, 'f', 0)
                      .arg(frame_rate_, 0, 'f', 0));
}

/// Also with nothing open: what is plugged in shows at once.
void MainWindow::show_device() {
  device_due_ = clock_.elapsed() + numbers_ms;
  const InputSource& source = devices_->source();
  const SourceReport report = devices_->report();
  device_panel_->show_choices(devices_->choices(), source);
  device_panel_->show_report(source, report);
  device_panel_->show_energy(shown_ ? shown_->hand.energy : HandEnergy{});
  QString text = QString::fromStdString(name_of(source));
  if (std::holds_alternative<ConnectedSource>(source)) {
    text += QStringLiteral(": ") + QLatin1String(name_of(report.device.state));
    if (report.clutch_open) text += QStringLiteral(", clutch open");
    if (!report.device.reason.empty())
      text += QStringLiteral(" (%1)").arg(QString::fromStdString(report.device.reason));
  }
  device_status_->setToolTip(text.toHtmlEscaped());
  constexpr int longest = 70;
  device_status_->setText(text.size() <= longest ? text : text.left(longest - 1) + QChar(0x2026));
}

bool MainWindow::save_picture(const QString& file) {
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

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls()) files.push_back(url.toLocalFile());
  event->acceptProposedAction();
  // Whoever drops is still holding a drag: answer it first, then ask and open.
  QTimer::singleShot(0, this, [this, files] {
    if (files.size() == 1 && is_recording(files[0].toStdString()))
      history_->open_recording(files[0]);
    else
      documents_->drop(files);
  });
}

}  // namespace sonde::ui
