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

/// Also its own inverse: another device's sets take the place of these.
class GainExchange : public QUndoCommand {
 public:
  GainExchange(GainSets& sets, const std::array<Coupling, 2>& others, std::size_t active)
      : QUndoCommand(QStringLiteral("Gains of another device")),
        sets_(sets),
        others_(others),
        active_(active) {}
  void redo() override { exchange(); }
  void undo() override { exchange(); }

 private:
  void exchange() {
    const std::array<Coupling, 2> now{sets_.gains(0), sets_.gains(1)};
    const std::size_t active = sets_.active();
    sets_.set(others_, active_);
    others_ = now;
    active_ = active;
  }

  GainSets& sets_;
  std::array<Coupling, 2> others_;
  std::size_t active_;
};

void GainSets::take(const Coupling& coupling) {
  sets_ = {coupling, coupling};
  active_ = 0;
  emit switched();
}

void GainSets::restore(const std::array<Coupling, 2>& sets, std::size_t active) {
  if (undo_.count() == 0) return set(sets, active);
  undo_.push(new GainExchange(*this, sets, active));
}

void GainSets::set(const std::array<Coupling, 2>& sets, std::size_t active) {
  sets_ = sets;
  active_ = active;
  panel_.apply(sets_.at(active_));
  emit switched();
}

void GainSets::set_other(const Coupling& coupling) {
  sets_.at(1 - active_) = coupling;
  emit switched();
}

Coupling GainSets::gains(std::size_t set) const {
  return set == active_ ? panel_.coupling() : sets_.at(set);
}

void GainSets::switch_over() { undo_.push(new GainSwitch(*this)); }

void GainSets::swap() {
  sets_.at(active_) = panel_.coupling();
  active_ = 1 - active_;
  panel_.apply(sets_.at(active_));
  emit switched();
}

}  // namespace sonde::ui
