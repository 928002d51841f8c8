// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/stiffness_control.hpp"

#include <utility>

#include "engine/settings/settings.hpp"
#include "engine/study/stability/press_and_hold.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "ui/base/format.hpp"
#include "ui/document/kept_gains.hpp"
#include "ui/document/session.hpp"
#include "ui/panels/coupling_panel.hpp"
#include "ui/panels/stiffness_panel.hpp"
#include "ui/tuning/gains_text.hpp"
#include "ui/tuning/present_contact.hpp"
#include "ui/tuning/stability_map.hpp"

namespace sonde::ui {
namespace {

constexpr int keep_ms = 300;            // a slider that moves writes no file for each step
constexpr qint64 buzz_ms = 100;         // it takes milliseconds: not with each frame
constexpr double course_seconds = 0.1;  // of the force: two swings at 20 Hz, where buzzing begins

/// The gains of now with what the study recommends in their place.
Coupling with_recommended(Coupling gains, const TuningResults& results) {
  const Coupling recommended = recommended_coupling(results);
  gains.mode = recommended.mode;
  for (const Setting& setting : coupling_settings()) {
    if (is_used(setting, gains.mode)) set(gains, setting.key, get(recommended, setting.key));
  }
  return gains;
}

}  // namespace

StiffnessControl::StiffnessControl(std::vector<std::filesystem::path> profile_folders,
                                   CouplingPanel& coupling, QUndoStack& undo, Prompts& prompts,
                                   QWidget& window)
    : QObject(&window),
      profile_folders_(std::move(profile_folders)),
      coupling_(coupling),
      prompts_(prompts),
      panel_(new StiffnessPanel(device_profile_ids(profile_folders_), &window)),
      tuner_(window, prompts),
      sets_(coupling, undo) {
  connect(&tuner_, &Tuner::ready, this, &StiffnessControl::take);
  connect(&tuner_, &Tuner::progressed, panel_, &StiffnessPanel::show_progress);
  connect(&tuner_, &Tuner::failed, this, &StiffnessControl::failed);
  connect(&sets_, &GainSets::switched, this, &StiffnessControl::show_sets);
  connect(panel_, &StiffnessPanel::load_asked, this, &StiffnessControl::ask_load);
  connect(panel_, &StiffnessPanel::compute_asked, this, &StiffnessControl::compute);
  connect(panel_, &StiffnessPanel::stop_asked, this, &StiffnessControl::stop);
  connect(panel_, &StiffnessPanel::save_asked, this, &StiffnessControl::ask_save);
  connect(panel_, &StiffnessPanel::gains_asked, this, &StiffnessControl::set_gains);
  connect(panel_, &StiffnessPanel::apply_asked, this, &StiffnessControl::apply_recommended);
  connect(panel_, &StiffnessPanel::switch_asked, this, &StiffnessControl::switch_gains);
  keep_timer_.setSingleShot(true);
  connect(&keep_timer_, &QTimer::timeout, this, &StiffnessControl::write_gains);
  show_gains(coupling_.coupling());
}

void StiffnessControl::attach(Session* session, bool same_gains) {
  keep_timer_.stop();  // the panel has other gains by now
  tuner_.abandon();
  session_ = session;
  tuning_.reset();
  buzz_.reset();
  note_ = {};
  contact_.clear();
  newest_contact_.clear();
  panel_->show_tuning(tuning_);
  panel_->show_contact({});
  panel_->clear_history();
  coupling_.show_rendered({});
  if (!session_) return;
  last_second_.take(session_->probe().mass);
  if (!same_gains) {
    gains_of_.clear();
    gains_file_.clear();
    scene_ = session_->loaded().scene;
    scene_.coupling = session_->coupling();
    sets_.take(session_->coupling());
  }
  show_gains(session_->coupling());
}

void StiffnessControl::set_holder(const Holder& holder) {
  holder_ = holder;
  panel_->show_device(holder.simulated ? holder.simulated->id : std::string(), holder.connected,
                      holder.model);
  if (!session_ || holder.name == gains_of_) return;
  keep_gains();
  gains_of_ = holder.name;
  gains_file_ = kept_gains_file(scene_, gains_of_);
  restore_gains();
}

void StiffnessControl::suit_other(const Coupling& suited,
                                  const std::function<bool(const Coupling&)>& untouched) {
  const Coupling other = sets_.gains(1 - sets_.active());
  if (!same(other, suited) && untouched(other)) sets_.set_other(suited);
}

void StiffnessControl::saved(const Scene& scene) {
  if (!session_ || gains_of_.empty()) return;
  keep_timer_.stop();
  scene_ = scene;
  gains_file_ = kept_gains_file(scene_, gains_of_);
  write_gains_now();
}

void StiffnessControl::restore_gains() {
  kept_ = {sets_.gains(0), sets_.gains(1)};
  kept_active_ = sets_.active();
  try {
    const auto kept = read_kept_gains(gains_file_, scene_.coupling);
    if (!kept) return;
    kept_ = kept->sets;
    kept_active_ = kept->active;
    const bool others = !same(kept_[kept_active_], sets_.gains(sets_.active()));
    sets_.restore(kept_, kept_active_);
    keep_timer_.stop();
    if (others)
      emit say(QStringLiteral(
          "Gains as they were last, here and with this device; the Coupling dock has "
          "those of the scene."));
  } catch (const InputError& bad) {
    prompts_.report_error(QString::fromUtf8(bad.what()));
  }
}

void StiffnessControl::keep_gains() {
  if (!keep_timer_.isActive()) return;
  keep_timer_.stop();
  write_gains();
}

void StiffnessControl::write_gains() {
  const bool as_kept = same(sets_.gains(0), kept_[0]) && same(sets_.gains(1), kept_[1]);
  if (gains_file_.empty() || (as_kept && sets_.active() == kept_active_)) return;
  write_gains_now();
}

void StiffnessControl::write_gains_now() {
  kept_ = {sets_.gains(0), sets_.gains(1)};
  kept_active_ = sets_.active();
  try {
    write_kept_gains(gains_file_, {kept_, kept_active_, scene_.coupling});
  } catch (const InputError& bad) {  // a full disk: what is felt is not affected
    emit say(QString::fromUtf8(bad.what()));
  }
}

void StiffnessControl::show_gains(const Coupling& gains) {
  panel_->show_gains(gains);
  show_sets();
}

void StiffnessControl::show_sets() {
  panel_->show_sets({sets_.gains(0), sets_.gains(1)}, sets_.active());
  // Not started anew: what a drag has come to is written while it goes on.
  if (session_ && !gains_file_.empty() && !keep_timer_.isActive()) keep_timer_.start(keep_ms);
}

void StiffnessControl::take(const Tuning& tuning) {
  tuning_ = tuning;
  panel_->show_tuning(tuning_);
}

void StiffnessControl::frame(qint64 now) {
  if (!session_) return;
  for (Snapshot tick; session_->next_tick(tick);) {
    last_second_.add(tick);
    emit ticked(tick);
    newest_ = tick.time;
    if (std::string kind = kind_of_contact(tick.separation); !kind.empty())
      newest_contact_ = std::move(kind);
  }
  if (now < buzz_due_) return;
  buzz_due_ = now + buzz_ms;
  if (session_->paused()) {
    buzz_.reset();
    coupling_.show_rendered({});
    return;
  }
  // A probe that jumps in and out of a contact is in it.
  contact_ = std::exchange(newest_contact_, {});
  buzz_ = last_second_.buzz();
  note_ = note_now();
  const bool waits = buzz_ && buzz_->waiting;
  coupling_.show_rendered(waits ? std::optional(buzz_->rendered) : std::nullopt);
  panel_->show_contact(contact_);
  if (panel_->isVisible()) panel_->show_buzz(buzz_, newest_);
}

bool StiffnessControl::is_of_what_is_open() const {
  const auto& simulated = holder_.simulated;
  return tuning_ && tuning_->doubt.isEmpty() &&
         (holder_.connected.isEmpty() || panel_->is_of_connected()) &&
         (!simulated || simulated->id == tuning_->results.device_id) &&
         session_->coupling().mode == tuning_->results.mode;
}

ForceNote StiffnessControl::note_now() const {
  ForceNote note;
  if (contact_.empty()) return note;
  if (is_of_what_is_open()) {
    const GainAxis axis = axes_of(tuning_->results).front();
    const MapPoint gains = point_of(session_->coupling(), axis);
    const auto allowed = allowed_at(tuning_->results, axis, gains.damping, contact_);
    const QString distance =
        allowed ? distance_text(gains.stiffness, allowed->stiffness) : QString();
    if (!distance.isEmpty())
      note.text = QStringLiteral("by the study of %1:\n%2 in %3 contact,\n%4")
                      .arg(text(tuning_->results.device_id), distance, text(contact_),
                           text(limit_in_words(*allowed)));
  }
  if (buzz_ && buzz_->waiting)
    note.text = QStringLiteral("%1 now: the gains set wait%2")
                    .arg(gains_text(buzz_->rendered).replace('\n', QStringLiteral(", ")),
                         note.text.isEmpty() ? QString() : '\n' + note.text);
  if (!buzz_ || !buzz_->chatter.buzzes()) return note;
  note.now = QStringLiteral("buzzing");
  note.course = last_second_.forces(course_seconds);
  return note;
}

void StiffnessControl::ask_load() {
  const QString folder = session_ ? prompts_.ask_tuning() : QString();
  if (!folder.isEmpty()) load(folder);
}

void StiffnessControl::load(const QString& folder) {
  if (session_) tuner_.load(folder, session_->loaded());
}

void StiffnessControl::compute() {
  if (!session_) return;
  const std::string id = panel_->device_id();
  try {
    const auto& simulated = holder_.simulated;
    const DeviceProfile device =
        simulated && simulated->id == id ? *simulated : find_device_profile(id, profile_folders_);
    tuner_.compute({.within = computed_studies_folder(),
                    .device = device,
                    .mode = session_->coupling().mode,
                    .kind = panel_->kind()},
                   session_->loaded());
  } catch (const InputError& bad) {
    prompts_.report_error(QString::fromUtf8(bad.what()));
  }
}

void StiffnessControl::ask_save() {
  if (!session_ || !tuning_ || !tuning_->finished()) return;
  const QString folder = prompts_.ask_tuning_folder();
  if (!folder.isEmpty()) tuner_.save(*tuning_, folder, session_->loaded());
}

void StiffnessControl::apply_recommended() {
  if (tuning_)
    coupling_.request(with_recommended(coupling_.coupling(), tuning_->results),
                      "Recommended gains");
}

void StiffnessControl::set_gains(GainAxis axis, double stiffness, double damping) {
  if (!tuning_) return;
  Coupling wanted = coupling_.coupling();
  wanted.mode = tuning_->results.mode;
  sonde::set_gains(wanted, axis, stiffness, damping, tuning_->results.joint);
  for (const Setting& setting : coupling_settings())  // into its range
    set(wanted, setting.key, get(wanted, setting.key));
  coupling_.request(wanted, "Gains from the map");
}

void StiffnessControl::switch_gains() {
  if (session_) sets_.switch_over();
}

}  // namespace sonde::ui
