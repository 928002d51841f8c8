// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "ui/actions/gain_sets.hpp"
#include "ui/actions/tuner.hpp"
#include "ui/tuning/last_second.hpp"

class QUndoStack;

namespace sonde::ui {

class CouplingPanel;
class Session;
class StiffnessPanel;

/// Everything behind the stiffness dock: the tuning of the open pair, the two sets of gains, and
/// the figures of the last second.
class StiffnessControl : public QObject {
 public:
  StiffnessControl(std::vector<std::filesystem::path> profile_folders, CouplingPanel& coupling,
                   QUndoStack& undo, Prompts& prompts, QWidget& window);

  StiffnessPanel& panel() { return *panel_; }
  const std::optional<Tuning>& tuning() const { return tuning_; }
  const GainSets& sets() const { return sets_; }
  /// The newest figures; none before a second of ticks, or while the dock is not visible.
  const std::optional<Buzz>& buzz() const { return buzz_; }

  /// Called with each tick of the session, in its order.
  std::function<void(const Snapshot&)> ticked;
  /// A study could not be read or made: the reason was reported already.
  std::function<void(const QString& reason)> failed;

  /// Another session was opened; null for none. `same_gains`: of the same scene, so that A and B
  /// stay.
  void attach(Session* session, bool same_gains = false);
  /// The device that is simulated; none: another, or none.
  void set_device(const std::optional<DeviceProfile>& device);
  /// The gains have changed, by whatever.
  void show_gains(const Coupling& gains);
  /// With each frame, at so many ms.
  void frame(qint64 now);

  void ask_load();
  void load(const QString& folder);
  void ask_compute();
  void compute(const QString& folder);
  void apply_recommended();
  void switch_gains();

 private:
  void show_sets();

  std::vector<std::filesystem::path> profile_folders_;
  CouplingPanel& coupling_;
  Prompts& prompts_;
  StiffnessPanel* panel_;
  Tuner tuner_;
  GainSets sets_;
  Session* session_ = nullptr;
  std::optional<DeviceProfile> device_;
  std::optional<Tuning> tuning_;
  LastSecond last_second_;
  std::optional<Buzz> buzz_;
  double newest_ = 0;  ///< s, of the last tick
  qint64 buzz_due_ = 0;
};

}  // namespace sonde::ui
