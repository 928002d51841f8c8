// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <cstddef>

#include "engine/haptics/coupling/coupling.hpp"

class QUndoStack;

namespace sonde::ui {

class CouplingPanel;

/// Two sets of gains, A and B, to feel one after the other. The sliders show and change the active
/// one; the other keeps its values. The panel, the stack and the sets live equally long.
class GainSets : public QObject {
  Q_OBJECT
 public:
  GainSets(CouplingPanel& panel, QUndoStack& undo) : panel_(panel), undo_(undo) {}

  /// A pair was opened: both sets are its gains, and A is active.
  void take(const Coupling& coupling);
  /// Both as they were kept. A step to undo where there are steps already: what they change is
  /// gains of before.
  void restore(const std::array<Coupling, 2>& sets, std::size_t active);
  /// The gains of the set that is not active, where nobody has chosen them: no step to undo.
  void set_other(const Coupling& coupling);
  std::size_t active() const { return active_; }
  Coupling gains(std::size_t set) const;
  /// Changes to the other set; can be undone.
  void switch_over();

 signals:
  /// The other set is active now, or has other gains.
  void switched();

 private:
  friend class GainSwitch;
  friend class GainExchange;
  void swap();
  void set(const std::array<Coupling, 2>& sets, std::size_t active);

  CouplingPanel& panel_;
  QUndoStack& undo_;
  std::array<Coupling, 2> sets_;  ///< that of the active one is the panel's
  std::size_t active_ = 0;
};

}  // namespace sonde::ui
