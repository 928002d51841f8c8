// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/gain_sets.hpp"

#include <QUndoCommand>
#include <QUndoStack>

#include "ui/panels/coupling_panel.hpp"

namespace sonde::ui {

/// Its own inverse, as long as what came after it is undone before it.
class GainSwitch : public QUndoCommand {
 public:
  explicit GainSwitch(GainSets& sets) : QUndoCommand(QStringLiteral("A/B")), sets_(sets) {}
  void redo() override { sets_.swap(); }
  void undo() override { sets_.swap(); }

 private:
  GainSets& sets_;
};

void GainSets::take(const Coupling& coupling) {
  sets_ = {coupling, coupling};
  active_ = 0;
  if (switched) switched();
}

void GainSets::restore(const std::array<Coupling, 2>& sets, std::size_t active) {
  sets_ = sets;
  active_ = active;
  panel_.apply(sets_.at(active_));
  if (switched) switched();
}

Coupling GainSets::gains(std::size_t set) const {
  return set == active_ ? panel_.coupling() : sets_.at(set);
}

void GainSets::switch_over() { undo_.push(new GainSwitch(*this)); }

void GainSets::swap() {
  sets_.at(active_) = panel_.coupling();
  active_ = 1 - active_;
  panel_.apply(sets_.at(active_));
  if (switched) switched();
}

}  // namespace sonde::ui
