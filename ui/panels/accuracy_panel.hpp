// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <optional>

#include "engine/calibration/knob.hpp"
#include "engine/haptics/loop/servo.hpp"
#include "ui/tuning/reached_accuracy.hpp"

class QButtonGroup;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace sonde::ui {

class Bar;
class SliderRow;

/// What the knob is worth on the open pair, by the calibration.
struct Expected {
  double time_us = 0;  ///< of a tick; 0: no limit
  double within = 0;   ///< of nine in ten ticks, share of the largest depth; infinite: not known
  /// The same, measured on this very scene; none where it was not, and why not where a file that
  /// should say it cannot be read.
  std::optional<double> here;
  QString no_here = {};
};

/// The dock of the one knob: the time of a tick or the accuracy that it should have, the accuracy
/// to expect of it, and what the last ticks reached, with where their time went.
class AccuracyPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit AccuracyPanel(QWidget* parent = nullptr);

  void show_knob(const ServoSettings& servo, const Expected& expected);
  /// None: too few ticks in contact lately.
  void show_reached(const std::optional<Reached>& reached);
  /// Of the last search beside the ticks: where its time went, and all of it, µs. Nothing where it
  /// was not timed.
  void show_search(const PhaseTimes& phases, double time_us);
  /// What the nearest way out of that search claims, and for which share of searches. None: there
  /// is no search.
  void show_claim(const std::optional<Claim>& claim, double sure);

  /// Which of the three is given: nothing, a time, an accuracy.
  enum class Knob { none, time, accuracy };

 signals:
  /// Another kind was chosen; its value follows from the present one.
  void kind_chosen(Knob kind);
  void time_changed(double time_us);
  void accuracy_changed(double share);
  void sure_changed(double share);

 private:
  void build_knob(QVBoxLayout& layout);
  void build_figures(QVBoxLayout& layout);
  void build_search(QVBoxLayout& layout);

  QButtonGroup* kinds_;
  SliderRow *time_, *accuracy_;
  QLabel *expected_, *here_, *reached_, *converged_, *rows_, *tick_;
  Bar* parts_;
  QLabel* phases_;
  QComboBox* sure_;
  QLabel *claim_, *search_time_;
  Bar* search_parts_;
  QLabel* search_phases_;
};

/// The range of the slider of time, µs, and of the slider of accuracy, as a share.
inline constexpr double least_time_us = 10, most_time_us = 10'000;
inline constexpr double least_share = 1e-5, most_share = 0.5;

}  // namespace sonde::ui
