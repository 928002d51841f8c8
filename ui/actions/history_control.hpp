// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "ui/actions/prompts.hpp"
#include "ui/base/job.hpp"
#include "ui/document/kept_ticks.hpp"
#include "ui/document/playback.hpp"
#include "ui/document/recorder.hpp"
#include "ui/document/tick_blocks.hpp"
#include "ui/panels/plots_panel.hpp"
#include "ui/panels/timeline_panel.hpp"
#include "ui/views/drawn_session.hpp"

namespace sonde::ui {

class DocumentControl;
class Opener;

/// Everything about time: keeps the last minutes of the session, records them, opens recordings,
/// shows any instant of them, and runs them again with other gains. While the user looks back the
/// servo is paused, so that what the hand feels is always what is on the screen.
class HistoryControl : public QObject {
  Q_OBJECT
 public:
  HistoryControl(Opener& opener, Prompts& prompts, DocumentControl& documents, QWidget& window);
  ~HistoryControl() override;

  TimelinePanel& timeline() { return *timeline_; }
  PlotsPanel& plots() { return *plots_; }
  const Playback& playback() const { return playback_; }
  const Recorder& recorder() const { return recorder_; }

  /// Another session is open, or none: the kept ticks are gone, and a recording ends.
  void attach(Session* session);
  void add(const Snapshot& tick) { recorder_.add(tick); }
  void add(const BackgroundResult& search) { recorder_.add(search); }
  void add(const GaugedClearance& clearance) { recorder_.add(clearance); }
  /// With each frame, at so many ms.
  void frame(qint64 now);

  /// None while the window shows the servo.
  std::optional<Instant> instant();
  bool looking_back() const { return playback_.looking(); }
  void look_at(double time);
  void step(int ticks);
  void play(bool on);
  /// Shows the run with other gains instead of the kept one, at the same time.
  void show_replay(bool on);
  /// Shows the servo again, which runs again if it ran before.
  void go_live();
  /// The same, and the servo stays as it is.
  void leave() { playback_.look_at(nullptr); }

  void set_recording(bool on);  ///< asks for a file
  void record(const QString& file);
  void ask_recording();
  /// With its scene, which becomes the document.
  void open_recording(const QString& file);

  /// Looks at other ticks of the session that is open, at that time, as at an opened recording.
  void show_kept(std::shared_ptr<KeptTicks> ticks, double time);

  /// The path of what is kept or was opened, with these gains; the method is Method::pdt for a run
  /// by translation alone. In a worker; ends in replayed().
  void run_again(Method method, const std::optional<Coupling>& gains);
  /// The same path with two sets of gains, both beside the kept one in the plots; the timeline
  /// leads over the first.
  void run_both(const Coupling& a, const Coupling& b);
  /// All that the timeline leads over now; none where that is nothing.
  std::optional<TickBlocks> ticks_on_show();
  /// The curves of what is on show, as `kept`, and where in them that is.
  PlotState course() const;
  const KeptTicks* replay() const { return replay_.get(); }
  const KeptTicks* second_replay() const { return second_.get(); }

 signals:
  void show_wanted(DrawnSession& drawn);  ///< to be taken
  void pause_wanted(bool on);
  void say(const QString& what);  ///< in passing
  void replayed();

 private:
  const TickLog* kept() const;  ///< that of the file, or of the session; null where there is none
  void try_to(const std::function<void()>& look);
  void check_not_in_use(const std::filesystem::path& file) const;
  void begin_looking();
  void stop_recording();
  void report_ended();
  const Curves* curves() const;
  bool may_run_again() const;
  void start_runs(Method method, const std::vector<std::optional<Coupling>>& gains);
  void show_runs(std::shared_ptr<KeptTicks> first, std::shared_ptr<KeptTicks> second);
  double shown_time(const TickLog& log) const;
  void show_state();
  void opened(DrawnSession drawn, const std::shared_ptr<KeptTicks>& recording);

  Opener& opener_;
  Prompts& prompts_;
  DocumentControl& documents_;
  Session* session_ = nullptr;
  TimelinePanel* timeline_;
  PlotsPanel* plots_;
  Job job_;
  Recorder recorder_;
  QTimer ending_timer_;  ///< while recordings that were stopped are written
  Playback playback_;
  std::shared_ptr<KeptTicks> opened_;  ///< of a file; null: the session's own
  std::shared_ptr<KeptTicks> replay_, second_;
  bool shows_replay_ = false;
  QString recording_since_;
  bool paused_before_ = false;
  qint64 last_frame_ = 0;
  qint64 state_due_ = 0;
};

}  // namespace sonde::ui
