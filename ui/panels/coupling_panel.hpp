// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <functional>
#include <optional>
#include <vector>

#include "engine/haptics/coupling/coupling.hpp"
#include "engine/haptics/coupling/gain_glide.hpp"

class QButtonGroup;
class QLabel;
class QUndoStack;

namespace sonde::ui {

class SliderRow;

/// The dock of gains: the mode of the coupling and a slider with a typed value for each setting of
/// the table. It hides rows that the mode does not use. Every change can be undone.
class CouplingPanel : public QDockWidget {
  Q_OBJECT
 public:
  explicit CouplingPanel(QUndoStack& undo, QWidget* parent = nullptr);

  /// Shows the gains of a newly opened pair; "defaults" goes back to these.
  void take(const Coupling& coupling);
  /// What "defaults" goes back to, without a change of what is set.
  void set_defaults(const Coupling& coupling) { defaults_ = coupling; }
  /// What to say of the gains that are set: asked with every change of them.
  void show_origin(std::function<QString(const Coupling&)> words);
  /// These gains are felt, for those set wait; none: those set are.
  void show_rendered(const std::optional<GainGlide::Blend>& instead);
  const Coupling& coupling() const { return coupling_; }

  /// Changes the gains as a slider does; `what` names the change for whoever undoes it.
  void request(const Coupling& wanted, const char* what);
  /// The same without an undo step, for callers that have their own.
  void apply(const Coupling& coupling);

 signals:
  /// Immediately, with every change.
  void changed(const Coupling& coupling);
  void mouse_gain_changed(double gain);

 private:
  void build();
  void show_values();

  QUndoStack& undo_;
  Coupling coupling_;
  Coupling defaults_;
  std::function<QString(const Coupling&)> origin_words_;
  QButtonGroup* modes_ = nullptr;
  QLabel *mode_doc_ = nullptr, *origin_ = nullptr, *waiting_ = nullptr;
  std::vector<SliderRow*> rows_;
};

}  // namespace sonde::ui
