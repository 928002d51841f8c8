// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QElapsedTimer>
#include <QMainWindow>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "ui/actions/prompts.hpp"
#include "ui/document/endings.hpp"
#include "ui/document/instant.hpp"
#include "ui/shell/escape_key.hpp"
#include "ui/shell/force_log.hpp"
#include "ui/shell/frame_rate.hpp"
#include "ui/shell/status_line.hpp"
#include "ui/views/drawn_session.hpp"

class QAction;
class QDockWidget;

namespace sonde::ui {

class AccuracyControl;
class ClashControl;
class CouplingPanel;
class DeviceControl;
class DevicePanel;
class DocumentControl;
class ExportControl;
class HistoryControl;
struct KeptTicks;
class LogPanel;
class MeasureControl;
class MouseProbe;
class Opener;
class PartsControl;
class PosePanel;
class ReadoutPanel;
class RepairsControl;
class SearchControl;
class SeeingControl;
class SideBar;
class SnapControl;
class StartPage;
class StiffnessControl;
class Viewport;
class WayInControl;

/// Of the window's state as it is kept between runs: others are not taken.
constexpr int state_version = 2;

/// The window: a view and docks, which show the newest instant sixty times a second. Its parts, and
/// which events each of them receives, are in main_window_parts.cpp.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  /// One scene, the probe and the fixed body, or one mesh, which asks for the other. Ends in
  /// opened() or open_failed().
  void open(const QStringList& files, std::optional<double> unit = std::nullopt);
  DocumentControl& documents() { return *documents_; }
  Session* session() { return drawn_.session.get(); }
  Viewport& viewport() { return *viewport_; }
  Prompts& prompts() { return prompts_; }
  /// What has been searched by the instant shown, with what was followed to.
  std::optional<BackgroundResult> searched() const {
    return instant_ ? instant_->searched : std::nullopt;
  }
  /// The newest snapshot shown; none before the first.
  const std::optional<Snapshot>& shown() const { return shown_; }
  DeviceControl& devices() { return *devices_; }
  StiffnessControl& stiffness() { return *stiffness_; }
  HistoryControl& history() { return *history_; }
  SeeingControl& seeing() { return *seeing_; }
  AccuracyControl& accuracy() { return *accuracy_; }
  ExportControl& exporter() { return *exporter_; }
  RepairsControl& repairs() { return *repairs_; }
  PartsControl& parts() { return *parts_; }
  WayInControl& way_in() { return *way_in_; }
  ClashControl& clash() { return *clash_; }
  /// Those that have a tab at a side.
  std::vector<QDockWidget*> docks_of_sides() const;
  /// Folds away what is open at the sides, and opens it again.
  void fold_docks();

  void ask_path();  ///< a recorded path, to hold the probe

  void show_device_dock();  ///< before the dock it shares its place with
  void set_device_pose(const Pose& X_FM);
  void set_paused(bool paused);
  /// False immediately on Esc where nothing is open in front of the window; true lets the force
  /// come back.
  void set_force(bool on);
  /// A hand at a device with motors feels the force: Esc stops it whatever is open.
  void set_felt(bool felt) { felt_ = felt; }
  void reset();
  /// Closes the document and shows the start page.
  void show_start_page();
  /// The same, with the reason why these files were not opened.
  void show_start_page(const QString& reason, const QStringList& files);
  /// No dock is on show until something is open.
  void clear_desk();
  /// Lets the separated probe swing between the hand and the pose where it is held.
  void set_swing(bool on) { swing_ = on; }
  /// Looks at ticks that were made elsewhere, at that time (HistoryControl::show_kept).
  void show_kept(const std::shared_ptr<KeptTicks>& ticks, double time);
  /// Includes docks and overlays. False, with a message, where the file cannot be written.
  bool save_picture(const QString& file);
  void ask_picture();

  /// Of the frame clock: how often the newest state was on screen, drawn anew or not.
  double frames_per_second() const { return frame_rate_.last(); }
  /// Drawn anew, since the start.
  std::size_t frames() const { return frames_; }

 signals:
  void opened();
  void open_failed(const QString& reason);
  void paused_changed(bool paused);
  void force_changed(bool on);

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void connect_opener();
  void connect_coupling();
  void connect_devices();
  void connect_measuring();
  void connect_documents();
  void connect_export();
  void add_history();
  void add_repairs();
  void add_assembly();
  void add_sides();
  void fade_hint();
  void lay_desk();
  void let_go_to_close();
  void place(const Pose& X_FM);
  void follow_mouse(const Pose& X_FM);
  void keep_motion(const Pose& before, bool one_of_many);
  void keep_tick(const Snapshot& tick);
  void set_coupling(const Coupling& coupling);
  void show_session(DrawnSession drawn, bool same_document = false);
  void show_nothing();
  void show_document();
  void show_parts(const std::vector<PartLook>& looks);
  void show_holder();
  void suit_gains();
  void on_frame();
  std::optional<Instant> newest();
  void measure_clearance(Instant& now);
  void draw_if_changed();
  void forget_shown() { shown_.reset(), instant_.reset(); }
  void pause(bool paused);
  void complain(const QString& reason);
  void tell(const QString& what);
  void tell_longer(const QString& what);
  bool open_recording(const QStringList& files);
  void open_one_mesh(const QString& file);
  bool wants_search() const;
  void show_numbers();
  void show_status();
  void show_device();
  void restore_window();

  Prompts prompts_;
  Endings endings_;        ///< of the sessions before
  QElapsedTimer closing_;  ///< since the window was to close, where a device is let go first
  DrawnSession drawn_;
  std::unique_ptr<Opener> opener_;
  Viewport* viewport_;
  std::unique_ptr<DocumentControl> documents_;
  MouseProbe* mouse_;
  CouplingPanel* coupling_panel_;
  ReadoutPanel* readout_;
  LogPanel* log_;
  PosePanel* pose_panel_;
  StartPage* start_page_;
  std::unique_ptr<DeviceControl> devices_;
  DevicePanel* device_panel_;
  MeasureControl* measure_;
  StiffnessControl* stiffness_;
  HistoryControl* history_ = nullptr;
  SeeingControl* seeing_ = nullptr;
  AccuracyControl* accuracy_ = nullptr;
  ExportControl* exporter_ = nullptr;
  RepairsControl* repairs_ = nullptr;
  PartsControl* parts_ = nullptr;
  WayInControl* way_in_ = nullptr;
  SnapControl* snap_ = nullptr;
  ClashControl* clash_ = nullptr;
  SideBar *left_ = nullptr, *right_ = nullptr;
  std::vector<QDockWidget*> folded_;  ///< by fold_docks()
  QByteArray desk_;                   ///< the state of the docks while the start page is on show
  StatusLine status_;
  EscapeKey escape_;
  QTimer frame_timer_;
  QElapsedTimer clock_;
  ForceLog force_log_;
  std::optional<Snapshot> shown_;
  std::optional<Instant> instant_;  ///< the same, with all that belongs to it
  std::unique_ptr<SearchControl> search_;
  std::optional<Coupling> suited_;  ///< the gains that were chosen for own meshes
  bool hint_unread_ = true;         ///< nobody has dragged the probe yet
  bool force_ = true;
  bool felt_ = false;
  bool swing_ = false;
  std::size_t frames_ = 0;
  FrameRate frame_rate_;
  qint64 numbers_due_ = 0;
  qint64 device_due_ = 0;
};

}  // namespace sonde::ui
