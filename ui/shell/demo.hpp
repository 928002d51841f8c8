// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/scene/poses.hpp"
#include "ui/base/job.hpp"
#include "ui/shell/demo_run.hpp"

namespace sonde::ui {

class MainWindow;

/// Moves the probe of an opened scene along the scene's trajectory, then shows the deepest pose of
/// that path and saves a picture. The deepest pose is found by a run of its own, tick by tick, so
/// the picture is the same however fast the display is.
class Demo : public QObject {
  Q_OBJECT
 public:
  Demo(MainWindow& window, std::string picture);

  /// Plays; then prints one line of figures and ends in ended() with an exit code.
  void play();

 signals:
  void ended(int exit_code);

 private:
  enum class Act { forward, rest };
  void step();
  void forward(double seconds);
  void run_by_tick();
  void show_deepest(const std::exception_ptr& error);
  void rest(double seconds);
  void end(int exit_code);
  Pose at(double place) const;  ///< 0 to 1 along the path
  void begin(Act act);
  int finish();

  MainWindow& window_;
  std::string picture_;
  std::vector<TimedPose> path_;
  QTimer timer_;
  QElapsedTimer clock_;
  Act act_ = Act::forward;
  double forward_seconds_ = 2.6;  ///< however long the trajectory is
  std::size_t frames_at_start_ = 0;
  double frames_per_second_ = 0;
  std::optional<Snapshot> live_;  ///< the servo's last tick on the path
  bool fitted_ = false;
  Job job_;
  std::shared_ptr<DemoRun> run_;
};

/// Share of a picture's pixels that differ from those of the left edge in the same row, where there
/// is only background.
double lit_share(const QImage& picture);

}  // namespace sonde::ui
