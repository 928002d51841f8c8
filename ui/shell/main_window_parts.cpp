// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is made of, and what of it is told what.
#include <vtkPolyData.h>

#include <QFileInfo>
#include <QStatusBar>
#include <QVBoxLayout>
#include <utility>

#include "ui/actions/accuracy_control.hpp"
#include "ui/actions/clash_control.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/export_control.hpp"
#include "ui/actions/history_control.hpp"
#include "ui/actions/measure_control.hpp"
#include "ui/actions/nudge_control.hpp"
#include "ui/actions/opener.hpp"
#include "ui/actions/parts_control.hpp"
#include "ui/actions/repairs_control.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/actions/snap_control.hpp"
#include "ui/actions/stiffness_control.hpp"
#include "ui/actions/way_in_control.hpp"
#include "ui/base/resources.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/devices/mouse_probe.hpp"
#include "ui/document/kept_gains.hpp"
#include "ui/panels/coupling_panel.hpp"
#include "ui/panels/device_panel.hpp"
#include "ui/panels/grip_box.hpp"
#include "ui/panels/log_panel.hpp"
#include "ui/panels/pose_panel.hpp"
#include "ui/panels/readout_panel.hpp"
#include "ui/panels/stiffness_panel.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/shell/menus.hpp"
#include "ui/shell/search_control.hpp"
#include "ui/shell/start_page.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr int frame_ms = 16;
constexpr int passing_ms = 4000;  // a message in passing

}  // namespace

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      prompts_(dialogs(*this)),
      opener_(std::make_unique<Opener>(*this, prompts_)),
      viewport_(new Viewport(this)),
      documents_(std::make_unique<DocumentControl>(*opener_, prompts_, *viewport_)),
      mouse_(new MouseProbe(*viewport_, this)),
      coupling_panel_(new CouplingPanel(documents_->document().stack(), this)),
      readout_(new ReadoutPanel(this)),
      log_(new LogPanel(this)),
      pose_panel_(new PosePanel(this)),
      start_page_(new StartPage(viewport_)),
      devices_(std::make_unique<DeviceControl>(device_settings_folder(), device_profile_folders())),
      device_panel_(new DevicePanel(this)),
      measure_(new MeasureControl(*devices_, device_profile_folders(), prompts_, *this)),
      stiffness_(new StiffnessControl(device_profile_folders(), *coupling_panel_,
                                      documents_->document().stack(), prompts_, *this)),
      status_(*statusBar()),
      escape_([this] { return felt_ || measure_->going_on(); }) {
  connect(&escape_, &EscapeKey::pressed, this, [this] { set_force(false); });
  setObjectName(QStringLiteral("main_window"));
  setWindowTitle(QStringLiteral("Sonde"));
  setAcceptDrops(true);
  add_repairs();
  setDockOptions(QMainWindow::AllowNestedDocks);  // the strips at the sides are their tabs
  for (QDockWidget* dock :
       {static_cast<QDockWidget*>(coupling_panel_), static_cast<QDockWidget*>(device_panel_),
        static_cast<QDockWidget*>(pose_panel_)})
    addDockWidget(Qt::LeftDockWidgetArea, dock);
  start_page_->hide();
  addDockWidget(Qt::RightDockWidgetArea, readout_);
  addDockWidget(Qt::RightDockWidgetArea, &stiffness_->panel());
  seeing_ = new SeeingControl(*viewport_, *documents_, *this, *readout_);
  add_assembly();
  accuracy_ = new AccuracyControl(*documents_, *this, *coupling_panel_);
  connect(seeing_, &SeeingControl::say, this, &MainWindow::tell);
  addDockWidget(Qt::BottomDockWidgetArea, log_);
  connect(statusBar(), &QStatusBar::messageChanged, log_, &LogPanel::add);
  add_history();
  connect_export();
  add_sides();
  add_menus(*this);
  connect(mouse_, &MouseProbe::moved, this, &MainWindow::follow_mouse);
  connect_coupling();
  connect(mouse_, &MouseProbe::settled, this, &MainWindow::keep_motion);
  connect(mouse_, &MouseProbe::say, this, &MainWindow::tell);
  connect_devices();
  connect_measuring();
  connect_documents();
  connect(stiffness_, &StiffnessControl::ticked, this, &MainWindow::keep_tick);
  connect(stiffness_, &StiffnessControl::say, this, &MainWindow::tell_longer);
  connect(stiffness_, &StiffnessControl::failed, log_, &LogPanel::add);
  connect_opener();
  connect(&frame_timer_, &QTimer::timeout, this, &MainWindow::on_frame);
  frame_timer_.setTimerType(Qt::PreciseTimer);
  frame_timer_.start(frame_ms);
  clock_.start();
  restore_window();
  viewport_->canvas()->setFocus();
}

/// In passing.
void MainWindow::tell(const QString& what) { statusBar()->showMessage(what, passing_ms); }

void MainWindow::tell_longer(const QString& what) {
  statusBar()->showMessage(what, 2 * passing_ms);
}

void MainWindow::follow_mouse(const Pose& X_FM) {
  if (session() && !history_->looking_back()) session()->set_device_pose(X_FM);
}

void MainWindow::keep_motion(const Pose& before, bool one_of_many) {
  if (history_->looking_back()) return;
  documents_->moved_from(before, one_of_many ? QStringLiteral("Nudge") : QStringLiteral("Drag"),
                         one_of_many);
  if (!one_of_many) fade_hint();
}

void MainWindow::keep_tick(const Snapshot& tick) {
  log_->add(force_log_.add(tick));
  history_->add(tick);
}

/// The loop first, then what shows or keeps it.
void MainWindow::connect_coupling() {
  connect(coupling_panel_, &CouplingPanel::changed, this, &MainWindow::set_coupling);
  connect(coupling_panel_, &CouplingPanel::changed, documents_.get(),
          &DocumentControl::set_coupling);
  connect(coupling_panel_, &CouplingPanel::changed, viewport_, &Viewport::set_coupling);
  connect(coupling_panel_, &CouplingPanel::changed, stiffness_, &StiffnessControl::show_gains);
  connect(coupling_panel_, &CouplingPanel::mouse_gain_changed, mouse_, &MouseProbe::set_gain);
}

void MainWindow::set_coupling(const Coupling& coupling) {
  if (session()) session()->set_coupling(coupling);
}

void MainWindow::connect_opener() {
  Opener* opener = opener_.get();
  connect(opener, &Opener::ready, this,
          [this](DrawnSession& drawn) { show_session(std::move(drawn)); });
  connect(opener, &Opener::say, this, &MainWindow::tell);
  connect(opener, &Opener::failed, log_, &LogPanel::add);
  connect(opener, &Opener::failed, this, &MainWindow::open_failed);
  // Nothing is being opened any more.
  connect(this, &MainWindow::open_failed, statusBar(), &QStatusBar::clearMessage);
}

void MainWindow::connect_devices() {
  DeviceControl* devices = devices_.get();
  connect(devices, &DeviceControl::changed, this, &MainWindow::show_holder);
  connect(devices, &DeviceControl::failed, this, &MainWindow::complain);
  connect(device_panel_, &DevicePanel::chosen, devices, &DeviceControl::choose);
  connect(device_panel_, &DevicePanel::path_wanted, this, &MainWindow::ask_path);
  connect(device_panel_, &DevicePanel::settings_changed, documents_.get(),
          &DocumentControl::set_device_settings);
  connect(&device_panel_->grip(), &GripBox::changed, devices, &DeviceControl::set_grip);
  device_panel_->grip().show_grip(devices_->grip());
  connect(device_panel_, &DevicePanel::led_switched, devices, &DeviceControl::set_led);
}

void MainWindow::connect_measuring() {
  connect(device_panel_, &DevicePanel::measure_asked, measure_, &MeasureControl::ask);
  connect(this, &MainWindow::force_changed, measure_, &MeasureControl::force_switched);
  connect(measure_, &MeasureControl::say, log_, &LogPanel::add);
  measure_->obstacle = [this] {
    if (!force_) return QStringLiteral("the force is off: switch it on first");
    if (!session() || session()->paused()) return QStringLiteral("the loop is paused");
    // Nobody would hold the handle when the force comes back.
    const bool touches = shown_ && shown_->separation.status == Status::penetrating;
    return touches ? QStringLiteral("the probe is in contact: move it out first") : QString();
  };
}

void MainWindow::add_history() {
  history_ = new HistoryControl(*opener_, prompts_, *documents_, *this);
  connect(history_, &HistoryControl::show_wanted, this,
          [this](DrawnSession& drawn) { show_session(std::move(drawn)); });
  connect(history_, &HistoryControl::pause_wanted, this, &MainWindow::pause);
  connect(history_, &HistoryControl::say, this, &MainWindow::tell);
  search_ = std::make_unique<SearchControl>(*viewport_, *history_);
  // Above the timeline, which keeps the whole width.
  splitDockWidget(log_, &history_->timeline(), Qt::Vertical);
  splitDockWidget(log_, &history_->plots(), Qt::Horizontal);
}

void MainWindow::add_assembly() {
  parts_ = new PartsControl(*viewport_, *documents_, prompts_, *this, *coupling_panel_);
  connect(seeing_, &SeeingControl::clicked, parts_, &PartsControl::click);
  way_in_ = new WayInControl(*viewport_, *this, *coupling_panel_);
  connect(way_in_, &WayInControl::follow_wanted, this, &MainWindow::set_device_pose);
  connect(way_in_, &WayInControl::place_wanted, documents_.get(),
          [this](const Pose& X_FM) { documents_->place(X_FM, QStringLiteral("Way in"), true); });
  snap_ = new SnapControl(*viewport_, *documents_, *pose_panel_, this);
  seeing_->add_taker(*way_in_);
  seeing_->add_taker(*snap_);
  clash_ = new ClashControl(*viewport_, *this, *coupling_panel_);
  auto* nudge = new NudgeControl(*viewport_, *pose_panel_, this);
  connect(seeing_, &SeeingControl::touched, nudge, &NudgeControl::click);
  connect(this, &MainWindow::opened, nudge, [this, nudge] { nudge->attach(session()->loaded()); });
}

/// The bar above the view: nothing in the view lies below it.
void MainWindow::add_repairs() {
  auto* middle = new QWidget(this);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  repairs_ = new RepairsControl(*viewport_, *documents_, *this);
  column->addWidget(&repairs_->bar());
  column->addWidget(viewport_, 1);
  middle->setFocusProxy(viewport_);  // who gives the keyboard back gives it to the view
  setCentralWidget(middle);
  connect(repairs_, &RepairsControl::say, this, &MainWindow::tell_longer);
}

void MainWindow::connect_export() {
  exporter_ = new ExportControl(*viewport_, instant_, *history_, prompts_, *this);
  connect(exporter_, &ExportControl::say, this, &MainWindow::tell);
  connect(exporter_, &ExportControl::failed, this, &MainWindow::complain);
}

void MainWindow::show_parts(const std::vector<PartLook>& looks) {
  const auto surface = viewport_->show_parts(looks);
  if (!surface) return;
  drawn_.bodies.fixed_surface = surface;
  drawn_.bodies.part_looks = looks;
}

void MainWindow::connect_documents() {
  DocumentControl* documents = documents_.get();
  connect(documents, &DocumentControl::show_wanted, this,
          [this](DrawnSession& drawn, bool same) { show_session(std::move(drawn), same); });
  connect(documents, &DocumentControl::emptied, this, &MainWindow::show_nothing);
  connect(documents, &DocumentControl::place_wanted, this, &MainWindow::place);
  connect(documents, &DocumentControl::coupling_changed, coupling_panel_, &CouplingPanel::apply);
  connect(documents, &DocumentControl::device_settings_changed, devices_.get(),
          &DeviceControl::set_settings);
  connect(documents, &DocumentControl::look_wanted, viewport_, &Viewport::look);
  connect(documents, &DocumentControl::parts_changed, this, &MainWindow::show_parts);
  connect(documents, &DocumentControl::say, this, &MainWindow::tell);
  connect(documents, &DocumentControl::changed, this, &MainWindow::show_document);
  connect(documents, &DocumentControl::saved, stiffness_, &StiffnessControl::saved);
  connect(pose_panel_, &PosePanel::placed, documents, [documents](const Pose& pose) {
    documents->place(pose, QStringLiteral("Place the probe"));
  });
  connect(pose_panel_, &PosePanel::nudge_changed, mouse_, &MouseProbe::set_nudge);
  connect(pose_panel_, &PosePanel::copy_wanted, documents, &DocumentControl::copy_pose);
  connect(pose_panel_, &PosePanel::copy_matrix_wanted, documents, &DocumentControl::copy_matrix);
  connect(pose_panel_, &PosePanel::paste_wanted, documents, &DocumentControl::paste_pose);
  connect(pose_panel_, &PosePanel::start_wanted, documents, &DocumentControl::start_from_here);
  connect(pose_panel_, &PosePanel::swap_wanted, documents, &DocumentControl::swap_bodies);
  connect(start_page_, &StartPage::scene_wanted, documents, &DocumentControl::ask_scene);
  connect(start_page_, &StartPage::meshes_wanted, documents,
          [documents] { documents->ask_meshes(); });
  connect(start_page_, &StartPage::chosen, this, [this](const QStringList& files) { open(files); });
}

void MainWindow::show_start_page(const QString& reason, const QStringList& files) {
  show_start_page();
  start_page_->complain(reason, [this, files] {
    const QString first = files.value(0);
    if (files.size() == 2 || DocumentControl::is_one_mesh(files))
      documents_->ask_meshes(QFileInfo::exists(first) && files.size() == 2 ? first : QString());
    else
      documents_->ask_scene();
  });
}

/// Gains of meshes without a scene suit the probe and the device, in both sets, until somebody
/// changes them.
void MainWindow::suit_gains() {
  if (!session()) return;
  const LoadedScene& loaded = session()->loaded();
  const auto* simulating = std::get_if<SimulatedSource>(&devices_->source());
  const auto device = simulating ? std::optional(simulating->profile) : std::nullopt;
  const MassProperties& probe = session()->probe().mass;
  const bool of_file = !loaded.scene.file.empty();
  coupling_panel_->show_origin(
      [=](const Coupling& now) { return text(origin_of_gains(now, of_file, probe, device)); });
  if (of_file) return;
  const Coupling now = session()->coupling();
  const Coupling suited = suited_coupling(probe, device ? &*device : nullptr);
  const auto untouched = [&loaded, before = suited_](const Coupling& gains) {
    return same(gains, loaded.coupling) || (before && same(gains, *before));
  };
  suited_ = suited;
  coupling_panel_->set_defaults(suited);
  stiffness_->suit_other(suited, untouched);
  if (!untouched(now) || same(now, suited)) return;
  Document& document = documents_->document();
  const bool modified = document.modified();
  coupling_panel_->apply(suited);
  if (!modified) document.set_saved_text(document.text());  // nobody has changed anything
  show_document();
}

}  // namespace sonde::ui
