// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/stiffness_control.hpp"

#include <utility>

#include "engine/settings/settings.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "ui/document/session.hpp"
#include "ui/panels/coupling_panel.hpp"
#include "ui/panels/stiffness_panel.hpp"

namespace sonde::ui {
namespace {

constexpr qint64 buzz_ms = 250;  // it takes milliseconds: not with each frame

/// The gains of now with what the study recommends in their place.
Coupling with_recommended(Coupling gains, const TuningResults& results) {
  const Coupling recommended = recommended_coupling(results);
  gains.mode = recommended.mode;
  for (const Setting& setting : coupling_settings()) {
    const std::string_view mode = setting.coupling_mode;
    if (mode.empty() || mode == name_of(gains.mode))
      set(gains, setting.key, get(recommended, setting.key));
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
  tuner_.ready = [this](Tuning tuning) {
    tuning_ = std::move(tuning);
    panel_->show_tuning(tuning_);
  };
  tuner_.failed = [this](const QString& reason) {
    if (failed) failed(reason);
  };
  sets_.switched = [this] { show_sets(); };
  panel_->load_asked = [this] { ask_load(); };
  panel_->compute_asked = [this] { ask_compute(); };
  panel_->apply_asked = [this] { apply_recommended(); };
  panel_->switch_asked = [this] { switch_gains(); };
  show_gains(coupling_.coupling());
}

void StiffnessControl::attach(Session* session, bool same_gains) {
  tuner_.abandon();
  session_ = session;
  tuning_.reset();
  buzz_.reset();
  panel_->show_tuning(tuning_);
  panel_->clear_history();
  if (!session_) return;
  last_second_.take(session_->probe().mass);
  if (!same_gains) sets_.take(session_->coupling());
  show_gains(session_->coupling());
}

void StiffnessControl::set_device(const std::optional<DeviceProfile>& device) {
  device_ = device;
  panel_->show_device(device_ ? device_->id : std::string());
}

void StiffnessControl::show_gains(const Coupling& gains) {
  panel_->show_gains(gains);
  show_sets();
}

void StiffnessControl::show_sets() {
  panel_->show_sets({sets_.gains(0), sets_.gains(1)}, sets_.active());
}

void StiffnessControl::frame(qint64 now) {
  if (!session_) return;
  for (Snapshot tick; session_->next_tick(tick);) {
    last_second_.add(tick);
    if (ticked) ticked(tick);
    newest_ = tick.time;
  }
  if (now < buzz_due_) return;
  buzz_due_ = now + buzz_ms;
  buzz_.reset();
  if (!panel_->isVisible() || session_->paused()) return;
  buzz_ = last_second_.buzz();
  panel_->show_buzz(buzz_, newest_);
}

void StiffnessControl::ask_load() {
  const QString folder = session_ ? prompts_.ask_tuning() : QString();
  if (!folder.isEmpty()) load(folder);
}

void StiffnessControl::load(const QString& folder) {
  if (session_) tuner_.load(folder, session_->loaded());
}

void StiffnessControl::ask_compute() {
  const QString folder = session_ ? prompts_.ask_tuning_folder() : QString();
  if (!folder.isEmpty()) compute(folder);
}

void StiffnessControl::compute(const QString& folder) {
  if (!session_) return;
  const std::string id = panel_->device_id();
  try {
    const DeviceProfile device =
        device_ && device_->id == id ? *device_ : find_device_profile(id, profile_folders_);
    tuner_.compute({.folder = folder.toStdString(),
                    .device = device,
                    .mode = session_->coupling().mode,
                    .kind = panel_->kind()},
                   session_->loaded());
  } catch (const InputError& bad) {
    prompts_.report_error(QString::fromUtf8(bad.what()));
  }
}

void StiffnessControl::apply_recommended() {
  if (tuning_)
    coupling_.request(with_recommended(coupling_.coupling(), tuning_->results),
                      "Recommended gains");
}

void StiffnessControl::switch_gains() {
  if (session_) sets_.switch_over();
}

}  // namespace sonde::ui
