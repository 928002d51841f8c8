// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <array>
#include <cstddef>
#include <optional>

#include "engine/geometry/pose.hpp"
#include "ui/base/format.hpp"
#include "ui/panels/offset_plot.hpp"
#include "ui/panels/travel_plot.hpp"

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace sonde::ui {

class NumberField;
class WorkRow;

/// A way on which the probe is put in, as it was asked for.
struct WayWanted {
  bool along_path = false;       ///< the scene's recorded one, rather than an axis
  Vec3 axis = -Vec3::UnitZ();    ///< in the fixed body's frame, of any length
  double travel = 0, twist = 0;  ///< m, rad
  double steps = 0;
};

/// The map of offsets and tilts at the mouth, as it was asked for.
struct MapWanted {
  double offset = 0, tilt = 0;       ///< the largest to either side, m and rad
  double across = 0;                 ///< how many of either
  std::optional<Vec3> lateral = {};  ///< along which the offsets are, of any length; none: any
};

/// What the next click in the view is to give.
enum class WayPick { nothing, axis_face, axis_edge, side_face, side_edge };

/// The dock of the way in: along which axis, how far, what happens on the way, and where it binds.
class WayInPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit WayInPanel(QWidget* parent = nullptr);

  /// A scene of that size was opened; there may be a recorded path.
  void take(double radius, bool has_path);
  /// Values that are no number are not a number.
  WayWanted wanted() const;
  MapWanted map_wanted() const;
  Vec3 axis() const;
  void show_axis(const Vec3& axis);
  /// Along which the offsets of the map are.
  void show_side(const Vec3& side);
  /// A click in the view is waited for.
  void show_picking(WayPick what);
  void show_progress(std::optional<double> fraction, double elapsed = 0);
  void show_result(const QString& summary, TravelCurves curves);
  /// Why there is none.
  void show_reason(const QString& reason);
  void show_at(double travel, const QString& words);
  void show_playing(bool on);
  void show_map_progress(std::optional<double> fraction, double elapsed = 0);
  /// `words`: about the map, or about the point of it that is chosen.
  void show_map(const QString& words, OffsetMap map);
  void show_map_place(const MapPlace& place, const QString& words);

 signals:
  void compute_wanted();
  void stop_wanted();
  void first_wanted();
  void map_asked();
  void map_stop_wanted();
  void map_place_wanted(const MapPlace& place);
  void pick_wanted(WayPick what);
  void play_wanted(bool on);
  void sought(double travel);

 private:
  void build_way(QVBoxLayout& layout);
  void build_result(QVBoxLayout& layout);
  void build_map(QVBoxLayout& layout);
  NumberField* field(const char* object, const char* doc);
  QPushButton* button(const char* text, const char* object, const char* doc);
  QPushButton* pick_button(WayPick what, const char* object, const char* doc);
  /// Three fields side by side.
  QHBoxLayout* fields(std::array<NumberField*, 3>& of, const std::array<const char*, 3>& objects,
                      const char* doc);

  QComboBox* kind_;
  std::array<NumberField*, 3> axis_{}, side_{};
  std::array<QPushButton*, 5> picks_{};  ///< by WayPick
  NumberField *travel_, *twist_, *steps_, *offset_, *tilt_, *across_;
  QLabel *travel_label_, *summary_, *at_, *offset_label_, *map_words_;
  QPushButton *flip_, *play_, *first_;
  WorkRow *work_, *map_work_;
  TravelPlot* plot_;
  OffsetPlot* map_;
  LengthUnit unit_;
};

}  // namespace sonde::ui
