// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <optional>

#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/penetration/search/pair.hpp"
#include "engine/recording/curves.hpp"
#include "ui/base/format.hpp"
#include "ui/document/instant.hpp"

class QFormLayout;
class QLabel;
class QVBoxLayout;

namespace sonde::ui {

class Bar;
class HistoryPlot;

/// The dock of numbers: how far from the hand the probe is held and by what motion, the nearest
/// ways out that a search found, force and torque against the device's limits, and the timing of
/// the servo.
class ReadoutPanel : public QDockWidget {
 public:
  explicit ReadoutPanel(QWidget* parent = nullptr);

  /// A new pair was opened.
  void take(const Pair& pair);
  /// The curves of the seconds before that time; null: there are none.
  void show_course(const Curves* curves, double until);
  /// Writes the numbers: a few times a second, so that they are legible.
  void show_numbers(const Instant& now);

 private:
  QLabel* value(QFormLayout& form, const QString& name, const char* object, const QString& doc);
  void build_held(QVBoxLayout& layout);
  void build_ways(QVBoxLayout& layout);
  void build_wrench(QVBoxLayout& layout);
  void build_loop(QVBoxLayout& layout);
  void show_held(const Instant& now);
  QString room_text(const Instant& now) const;
  QStringList screw_texts(const SeparationMotion& motion) const;
  void show_ways(const Separation& separation, const std::optional<BackgroundResult>& searched);
  void show_wrench(const Snapshot& snapshot);
  void show_loop(const Snapshot& snapshot);

  std::optional<Pair> pair_;
  MassProperties mass_;
  LengthUnit unit_;
  Coupling coupling_;
  QLabel *depth_, *translation_, *rotation_, *screw_, *nearest_, *why_, *pdt_, *bound_, *force_,
      *torque_, *contacts_, *force_parts_, *torque_parts_, *lessened_, *tick_, *rate_, *late_,
      *steps_;
  Bar *split_, *force_bar_, *torque_bar_;
  HistoryPlot *depth_plot_, *force_plot_;
};

}  // namespace sonde::ui
