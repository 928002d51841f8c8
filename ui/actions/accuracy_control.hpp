// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <optional>

#include "engine/calibration/calibration.hpp"
#include "ui/panels/accuracy_panel.hpp"

class QMainWindow;

namespace sonde::ui {

class DocumentControl;
class Session;

/// Everything behind the dock of the one knob. What it changes is a command of the document, so it
/// is saved with the scene and can be undone.
class AccuracyControl : public QObject {
 public:
  /// Its dock is added to the window, in the place of that one.
  AccuracyControl(DocumentControl& documents, QMainWindow& window, QDockWidget& beside);

  AccuracyPanel& panel() { return *panel_; }
  bool is_on_show() const;
  /// Another session was opened; null for none.
  void attach(Session* session);
  /// The document may say something else now.
  void show_knob();
  /// Of each picture: does nothing where nobody sees the dock.
  void frame(const Snapshot& tick, qint64 now);

 private:
  void choose(AccuracyPanel::Knob kind);
  void change(double time_us, double accuracy);
  void be_sure(double share);
  void show_search();
  std::string bundled_scene() const;
  struct Measured {
    std::filesystem::path scene;
    Calibration calibration;
    QString wrong;  ///< why a file that is there could not be read
  };
  /// On the open scene itself; read again where it is another one.
  const Measured& measured_here() const;
  Expected expected(const ServoSettings& servo) const;
  /// Of the open pair; the calibration is read with its first use.
  const AccuracyCurve& curve() const;

  DocumentControl& documents_;
  AccuracyPanel* panel_;
  Session* session_ = nullptr;
  bool has_sketches_ = false;  ///< the open pair has sketches
  double sure_ = usually_sure;
  mutable std::optional<AccuracyCurve> curve_;
  std::optional<AccuracyCurve> search_curve_;  ///< of searches that are as sure as sure_
  mutable std::optional<Measured> here_;
  ReachedAccuracy reached_;
  qint64 due_ = 0;
};

}  // namespace sonde::ui
