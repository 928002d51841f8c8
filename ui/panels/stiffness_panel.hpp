// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ui/tuning/last_second.hpp"
#include "ui/tuning/tuning.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace sonde::ui {

class CurvesDialog;
class LastSecondBox;
class MapPlot;
class StudyBox;
class StudyProgressRow;
struct MapPoint;
struct StudyProgress;

/// The dock of stiffness: the map that `sonde tune` measured with the present gains on it, the
/// recommended gains and the reason, the figures of the last second, and two sets of gains to
/// compare.
class StiffnessPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit StiffnessPanel(const std::vector<std::string>& device_ids, QWidget* parent = nullptr);

  /// A pair was opened: the curve starts over.
  void clear_history();
  /// None: there is nothing to show yet.
  void show_tuning(const std::optional<Tuning>& tuning);
  /// The device that is simulated now, which is then the one to compute for; empty: none.
  /// `connected`: the name of a force device that is not simulated; empty: there is none. `model`:
  /// the profile that its name says, which is then the one to compute for; empty: none.
  void show_device(const std::string& id, const QString& connected, const std::string& model = {});
  /// Whether the map is of the connected device, as far as names tell.
  bool is_of_connected() const;
  void show_gains(const Coupling& now);
  /// The kind of the contact that holds the probe; empty: none.
  void show_contact(const std::string& kind);
  /// Of a study that is computed; none: none is.
  void show_progress(const std::optional<StudyProgress>& progress);
  void show_sets(const std::array<Coupling, 2>& sets, std::size_t active);
  /// At the time (s) of the newest tick; none: nothing has run for a second.
  void show_buzz(const std::optional<Buzz>& buzz, double time);

  /// The user's choice of what to compute.
  std::string device_id() const;
  std::string kind() const;  ///< empty: all

 signals:
  void load_asked();
  void compute_asked();
  void save_asked();
  void stop_asked();
  void apply_asked();
  void switch_asked();
  /// A click on the map: stiffness and damping of an axis, in the units of StabilityMap.
  void gains_asked(GainAxis axis, double stiffness, double damping);

 private:
  QPushButton* button(const QString& text, const char* object, const QString& doc);
  void build_study(QVBoxLayout& layout, const std::vector<std::string>& device_ids);
  void build_map(QVBoxLayout& layout);
  void build_sets(QVBoxLayout& layout);
  void choose_axes();
  void show_map();
  void show_curves();
  void show_point();
  void show_doubt();
  void show_source();
  void mark_contact();
  bool recommends() const;
  QString contact_words(const MapPoint& point) const;
  GainAxis axis() const;

  std::optional<Tuning> tuning_;
  Coupling now_;
  std::string simulated_, model_, contact_;
  std::vector<std::string> known_;  ///< ids of profiles
  QString connected_;
  QComboBox *axes_, *shown_kinds_;
  StudyBox* study_;
  StudyProgressRow* progress_;
  QWidget* map_box_;
  MapPlot* plot_;
  QLabel *doubt_, *place_, *words_;
  QPushButton *apply_, *of_device_;
  CurvesDialog* curves_ = nullptr;  ///< made when it is first asked for
  std::array<QPushButton*, 2> sets_;
  LastSecondBox* last_second_;
};

}  // namespace sonde::ui
