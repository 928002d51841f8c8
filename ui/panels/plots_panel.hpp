// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <array>
#include <optional>

#include "ui/panels/time_charts.hpp"

class QAction;
class QCheckBox;
class QLabel;
class QMenu;

namespace sonde::ui {

/// What there is to plot.
struct PlotState {
  const Curves* kept = nullptr;    ///< null: nothing yet
  const Curves* replay = nullptr;  ///< the same path with other gains; null: none
  const Curves* second = nullptr;  ///< with the gains B, where `replay` is with A; null: none
  double time = 0;                 ///< s, the shown time
};

/// The dock of curves over time: which ones, over how long a time, and their values at the cursor.
/// It draws only while it is visible, and a few times a second.
class PlotsPanel : public QDockWidget {
  Q_OBJECT
 public:
  static constexpr double first_span = 10;  ///< s
  static constexpr double longest_span = 900, shortest_span = 0.01;

  explicit PlotsPanel(QWidget* parent = nullptr);

  /// Shows other ticks, of a probe whose lengths have this unit.
  void take(const LengthUnit& unit);
  /// The curves of the last state are about to go.
  void forget() { state_ = {}; }
  /// With each frame, at so many ms. The curves must stay until the next state, or forget().
  void show_state(const PlotState& state, qint64 now);

  void set_shown(Curve curve, bool on);
  bool shown(Curve curve) const;
  double from() const { return from_; }
  double to() const { return to_; }
  /// The newest tick stays at the right until the user moves the picture.
  bool follows() const;
  TimeCharts& charts() { return *charts_; }
  std::size_t drawn() const { return drawn_; }  ///< pictures so far

 signals:
  void sought(double time);

 private:
  void build_menu(QMenu& menu);
  void zoom(double factor, double about);
  void follow();
  void read_out(double time);
  ChartView view() const;

  LengthUnit unit_;
  PlotState state_;
  std::array<QAction*, curve_count> shown_{};
  TimeCharts* charts_;
  QCheckBox *follow_, *hold_;
  QLabel* values_;
  double from_ = 0, to_ = first_span;
  std::optional<double> hovered_;
  bool dirty_ = true;
  qint64 due_ = 0;
  std::size_t drawn_ = 0;
};

}  // namespace sonde::ui
