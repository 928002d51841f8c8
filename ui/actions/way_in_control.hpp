// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QTimer>
#include <memory>
#include <optional>

#include "engine/study/assembly/insertion.hpp"
#include "ui/actions/click_taker.hpp"
#include "ui/actions/flight.hpp"
#include "ui/base/job.hpp"
#include "ui/panels/offset_plot.hpp"

class QDockWidget;
class QMainWindow;

namespace sonde::ui {

class Session;
class Viewport;
class WayInPanel;
enum class WayPick;

/// The way in: what `sonde insert` says of the open scene, from where the probe is; computed beside
/// everything else, played and sought by the probe itself.
class WayInControl : public QObject, public ClickTaker {
  Q_OBJECT
 public:
  /// Its dock is added to the window, in the place of that one.
  WayInControl(Viewport& viewport, QMainWindow& window, QDockWidget& beside);

  WayInPanel& panel() { return *panel_; }
  /// Null: nothing is open. What is being computed is given up.
  void attach(Session* session, bool same_document = false);
  void compute();
  void stop() { job_.cancel(); }
  /// How it may be off where it is now, and still go in along the axis.
  void compute_map();
  /// The probe goes to the mouth, off by what that point of the map says.
  void to_map_place(const MapPlace& place);
  /// Along the way, in a fraction of a second.
  void seek(double travel);
  void play(bool on);
  void to_first_contact();
  /// A click in the view; true where an axis was waited for.
  bool click(QPointF at) override;
  const std::optional<Insertion>& found() const { return found_; }
  const OffsetMap& map() const { return map_; }

 signals:
  void follow_wanted(const Pose& X_FM);  ///< the hand goes there, as it would move
  void place_wanted(const Pose& X_FM);   ///< the probe is there at once: a step of undo

 private:
  struct Work;
  struct MapWork;
  void pick(WayPick what);
  void take(Work& work);
  void take_map(MapWork& work);
  QString summary() const;
  QString words_of_map() const;
  const InsertionStep& step_nearest(double travel) const;
  QString words_at(double travel) const;
  void go_to(double travel, double seconds);
  void step_on();

  Viewport& viewport_;
  WayInPanel* panel_;
  Session* session_ = nullptr;
  Job job_, map_job_;
  Flight flight_;
  WayPick picking_{};  ///< nothing
  InsertionPath way_;
  std::optional<Insertion> found_;
  InsertionPath map_way_;  ///< that the map is about
  OffsetMap map_;
  double at_ = 0, goal_ = 0;  ///< m along the way: where the probe is, and is to be
  double pace_ = 0;           ///< m a step
  std::optional<Pose> sent_;  ///< where the probe was sent last
  bool playing_ = false;
  QTimer steps_;
};

}  // namespace sonde::ui
