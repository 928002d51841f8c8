// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>
#include <vector>

#include "engine/haptics/loop/servo.hpp"
#include "ui/actions/crossing_finder.hpp"
#include "ui/actions/gap_painter.hpp"
#include "ui/views/seeing.hpp"

class QDockWidget;
class QMainWindow;

namespace sonde::ui {

class ClickTaker;
class ContactsPanel;
class DocumentControl;
class SeeingPanel;
struct SavedView;
class Session;
class ViewPick;
class Viewport;

/// Everything about seeing inside: the look of the bodies, the cut, measuring, the list of
/// contacts, the colours of the gap, and the view directions.
class SeeingControl : public QObject {
  Q_OBJECT
 public:
  /// Its docks are added to the window, in the place of that one.
  SeeingControl(Viewport& viewport, DocumentControl& documents, QMainWindow& window,
                QDockWidget& beside);
  ~SeeingControl() override;

  void attach(Session* session);
  /// Before each picture, of what it will show.
  void frame(const Snapshot& snapshot);
  /// A few times a second: what people read.
  void show_numbers(const Snapshot& snapshot);
  /// The document may have other views now.
  void show_saved();

  const Seeing& seeing() const { return seeing_; }
  void set_seeing(const Seeing& seeing);
  void set_cut(bool on);
  void set_measuring(bool on);
  void set_gaps(bool on) { gaps_.set_on(on); }
  CrossingFinder& crossings() { return crossings_; }
  void set_follow(bool on) { follow_ = on; }
  void snap_cut();
  void face_cut();
  /// From that direction of the fixed body's axes, all of the scene.
  void look_from(const Vec3& direction, const Vec3& up);
  void save_view();
  void forget_view(int index);
  void go_to_view(int index);
  void choose_contact(std::uint64_t id);

  /// A click in the view is that one's before all else, and after those who were added before.
  void add_taker(ClickTaker& taker) { takers_.push_back(&taker); }

 signals:
  void changed();  ///< seeing() says something else
  void say(const QString& what);
  void clicked(QPointF at);  ///< in the view, on no contact
  void touched(QPointF at);  ///< a click in the view, before it does whatever it is for

 private:
  void measure(QPointF at);
  void move_cut(double along);
  void turn_cut(const Vec3& turn);
  void click(QPointF at);
  void follow(const Snapshot& snapshot);
  const ContactCluster* leading() const;
  void change_views(const QString& what,
                    const std::function<bool(std::vector<SavedView>&)>& change);

  Viewport& viewport_;
  DocumentControl& documents_;
  Session* session_ = nullptr;
  SeeingPanel* panel_;
  ContactsPanel* contacts_;
  ViewPick* pick_;
  GapPainter gaps_;
  CrossingFinder crossings_;
  Seeing seeing_;
  Separation shown_;
  Wrench wrench_;
  bool follow_ = false;
  std::vector<ClickTaker*> takers_;
};

}  // namespace sonde::ui
