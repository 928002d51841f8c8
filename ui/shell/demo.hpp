// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <string>
#include <vector>

#include "engine/scene/poses.hpp"

namespace sonde::ui {

class MainWindow;

/// Moves the probe of an opened scene along the scene's trajectory, goes back to its deepest pose,
/// waits until the view shows it, and saves a picture.
class Demo : public QObject {
 public:
  Demo(MainWindow& window, std::string picture);

  /// Plays; then prints one line of figures and calls `ended` with an exit code.
  void play();
  std::function<void(int exit_code)> ended;

 private:
  enum class Act { forward, back, rest };
  void step();
  void forward(double seconds);
  void back(double seconds);
  void rest(double seconds);
  void watch(double place);
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
  double deepest_ = -1;           ///< m
  double deepest_place_ = 1;      ///< 0 to 1 along the path
  std::size_t frames_at_start_ = 0;
  double motion_seconds_ = 0;
  double frames_per_second_ = 0;
  double caught_up_at_ = 0;  ///< s into the rest
};

/// Share of a picture's pixels that differ from those of the left edge in the same row, where there
/// is only background.
double lit_share(const QImage& picture);

}  // namespace sonde::ui
