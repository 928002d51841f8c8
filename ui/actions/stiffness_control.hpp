// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "ui/actions/gain_sets.hpp"
#include "ui/actions/tuner.hpp"
#include "ui/tuning/last_second.hpp"
#include "ui/views/force_note.hpp"

class QUndoStack;

namespace sonde::ui {

class CouplingPanel;
class Session;
class StiffnessPanel;

/// Everything behind the stiffness dock: the tuning of the open pair, the two sets of gains, and
/// the figures of the last second.
class StiffnessControl : public QObject {
  Q_OBJECT
 public:
  StiffnessControl(std::vector<std::filesystem::path> profile_folders, CouplingPanel& coupling,
                   QUndoStack& undo, Prompts& prompts, QWidget& window);

  StiffnessPanel& panel() { return *panel_; }
  const std::optional<Tuning>& tuning() const { return tuning_; }
  const GainSets& sets() const { return sets_; }
  /// The newest figures; none before a second of ticks, or in a pause.
  const std::optional<Buzz>& buzz() const { return buzz_; }
  /// What the view says of it beside the force: whether it buzzes, and how far the gains are from
  /// what is allowed in the present contact, where a map of this pair and device tells.
  const ForceNote& note() const { return note_; }

  /// Another session was opened; null for none. `same_gains`: of the same scene, so that A and B
  /// stay.
  void attach(Session* session, bool same_gains = false);
  /// What holds the probe.
  struct Holder {
    std::optional<DeviceProfile> simulated;  ///< none: another, or none
    std::string name;                        ///< under which gains are kept for it
    QString connected;       ///< the name of a real force device; empty: there is none
    std::string model = {};  ///< the id of its profile, by that name; empty: none
  };
  /// After attach(), and where it is another: the sets are those that were kept for the open scene
  /// and it, if there are any.
  void set_holder(const Holder& holder);
  /// The set that is not active gets these gains, where `untouched` says that nobody has changed
  /// its own.
  void suit_other(const Coupling& suited, const std::function<bool(const Coupling&)>& untouched);
  /// The document was saved as this scene: what is kept is kept for that from now on.
  void saved(const Scene& scene);
  /// Writes what a timer would in a moment: before the session, or the coupling's panel, has gone.
  void keep_gains();
  /// The gains have changed, by whatever.
  void show_gains(const Coupling& gains);
  /// With each frame, at so many ms.
  void frame(qint64 now);

  void ask_load();
  void load(const QString& folder);
  /// Beside everything else, into a folder that nobody need know.
  void compute();
  bool computing() const { return tuner_.computing(); }
  void stop() { tuner_.stop(); }
  void ask_save();
  void apply_recommended();
  /// Stiffness and damping of an axis, in the units of StabilityMap; together with k_t and b_t,
  /// k_r and b_r follow as in the study.
  void set_gains(GainAxis axis, double stiffness, double damping);
  void switch_gains();

 signals:
  /// Each tick of the session, in its order.
  void ticked(const Snapshot& tick);
  /// A study could not be read or made: the reason was reported already.
  void failed(const QString& reason);
  void say(const QString& what);  ///< in passing

 private:
  void show_sets();
  void take(const Tuning& tuning);
  bool is_of_what_is_open() const;
  void restore_gains();
  void write_gains();
  void write_gains_now();
  ForceNote note_now() const;

  std::vector<std::filesystem::path> profile_folders_;
  CouplingPanel& coupling_;
  Prompts& prompts_;
  StiffnessPanel* panel_;
  Tuner tuner_;
  GainSets sets_;
  Session* session_ = nullptr;
  Holder holder_;
  Scene scene_;                       ///< for which gains are kept, with its own
  std::filesystem::path gains_file_;  ///< of that scene and what holds the probe
  std::string gains_of_;              ///< what holds the probe, for which they were restored
  std::array<Coupling, 2> kept_{};    ///< what the file has, or what it need not have
  std::size_t kept_active_ = 0;
  QTimer keep_timer_;
  std::optional<Tuning> tuning_;
  LastSecond last_second_;
  std::optional<Buzz> buzz_;
  std::string contact_, newest_contact_;  ///< kinds; empty: none
  ForceNote note_;
  double newest_ = 0;  ///< s, of the last tick
  qint64 buzz_due_ = 0;
};

}  // namespace sonde::ui
