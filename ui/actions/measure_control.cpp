// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/measure_control.hpp"

#include <QDate>
#include <algorithm>
#include <exception>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/settings/profile_match.hpp"
#include "engine/study/identification/identified_profile.hpp"
#include "engine/study/identification/measured_hand.hpp"
#include "engine/text/output_file.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui {
namespace {

constexpr int look_ms = 50;

/// The id of the model that the device's name says, not of one that was measured; else the first.
QString nearest_profile(const QStringList& ids, const QString& device) {
  std::vector<DeviceProfile> profiles;
  for (const QString& id : ids) {
    profiles.emplace_back();
    profiles.back().id = id.toStdString();
  }
  std::erase_if(profiles, is_measured);
  const DeviceProfile* found = profile_of(device.toStdString(), profiles);
  if (found) return text(found->id);
  return profiles.empty() ? ids.value(0) : text(profiles.front().id);
}

QString reason_of(const PulseProgress& progress) {
  if (progress.end == PulsesEnd::withheld) return QString::fromUtf8(words(progress.withheld));
  return QString::fromUtf8(words(progress.end));
}

}  // namespace

MeasureControl::MeasureControl(DeviceControl& devices,
                               std::vector<std::filesystem::path> profile_folders, Prompts& prompts,
                               QWidget& window)
    : QObject(&window),
      devices_(devices),
      profile_folders_(std::move(profile_folders)),
      prompts_(prompts),
      window_(window),
      job_(&window) {
  job_.stay_back();
  connect(&timer_, &QTimer::timeout, this, &MeasureControl::look);
}

void MeasureControl::ask() {
  if (dialog_ || !devices_.report().measurable) return;
  dialog_ = new MeasureDialog(&window_);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(&job_, &Job::progressed, dialog_, &MeasureDialog::show_computing);
  connect(dialog_, &MeasureDialog::start_asked, this, &MeasureControl::start);
  connect(dialog_, &MeasureDialog::cancel_asked, this,
          [this] { stop(QStringLiteral("cancelled")); });
  connect(dialog_, &MeasureDialog::profile_chosen, this, &MeasureControl::show_subject);
  connect(dialog_, &MeasureDialog::save_asked, this, &MeasureControl::save);
  connect(dialog_, &MeasureDialog::use_asked, this, &MeasureControl::use);
  show_subject({});
  if (dialog_) dialog_->open();
}

/// A simulated device has its profile; for a connected one it is chosen.
void MeasureControl::show_subject(const QString& profile_id) {
  subject_ = {};
  subject_.device = text(name_of(devices_.source()));
  subject_.sample_time = 1 / devices_.servo().rate_hz;
  if (const auto* simulated = std::get_if<SimulatedSource>(&devices_.source())) {
    subject_.profile = simulated->profile;
  } else
    try {
      for (const std::string& id : device_profile_ids(profile_folders_))
        subject_.profiles << text(id);
      const QString id =
          profile_id.isEmpty() ? nearest_profile(subject_.profiles, subject_.device) : profile_id;
      subject_.profile = with_limits_of(find_device_profile(id.toStdString(), profile_folders_),
                                        devices_.report().device.capabilities);
    } catch (const InputError& bad) {
      dialog_->deleteLater();
      dialog_ = nullptr;
      return prompts_.report_error(QString::fromUtf8(bad.what()));
    }
  dialog_->show_consent(subject_);
}

void MeasureControl::start() {
  if (going_on()) return;
  if (const QString why = obstacle ? obstacle() : QString(); !why.isEmpty())
    return dialog_->show_ended(why);
  try {
    const PulseLimits limits = dialog_->limits();
    plan_ = plan_pulses(subject_.profile, limits, subject_.sample_time);
    hand_ = devices_.begin_measuring(plan_, bounds_of(plan_, limits));
  } catch (const std::invalid_argument& why) {
    return dialog_->show_ended(QString::fromUtf8(why.what()));
  }
  if (!hand_) return dialog_->show_ended(QStringLiteral("the device is not there any more"));
  emit say(QStringLiteral("Measuring %1.").arg(subject_.device));
  timer_.start(look_ms);
  look();
}

void MeasureControl::stop(const QString& reason) {
  job_.abandon();
  timer_.stop();
  if (const auto hand = std::exchange(hand_, nullptr)) {
    hand->pulses().stop();
    devices_.end_measuring();
  }
  emit say(QStringLiteral("The measurement ended: %1.").arg(reason));
  if (dialog_) dialog_->show_ended(reason);
}

void MeasureControl::force_switched(bool on) {
  if (!on && hand_) stop(QStringLiteral("the force was switched off"));
}

void MeasureControl::look() {
  const PulseProgress progress = hand_->pulses().progress();
  if (!dialog_) return stop(QStringLiteral("cancelled"));
  if (progress.end == PulsesEnd::done) {
    timer_.stop();
    const auto hand = std::exchange(hand_, nullptr);
    devices_.end_measuring();
    return compute(hand->pulses().response());
  }
  if (!devices_.measuring()) return stop(QStringLiteral("something else holds the probe now"));
  if (progress.end != PulsesEnd::none) return stop(reason_of(progress));
  dialog_->show_progress(plan_, progress);
}

void MeasureControl::compute(const Response& response) {
  dialog_->show_computing(0);
  const auto found = std::make_shared<Identification>();
  found_ = found;
  job_.start(
      {},
      [found, response](const Progress& progress) {
        *found = identify(response, Rows::all_logged, progress);
      },
      [this](const std::exception_ptr& error) { take(error); });
}

void MeasureControl::take(const std::exception_ptr& error) {
  if (!dialog_) return;
  if (error) return dialog_->show_ended(ui::reason_of(error));
  saved_.reset();
  dialog_->show_result(*found_, subject_.profile);
}

QString MeasureControl::source() const {
  std::size_t pulses = 0;
  for (const IdentifiedAxis& axis : found_->axes) pulses += axis.pulses;
  return QStringLiteral("measured by Sonde on %1, %2 pulses of %3; low and high: 99 %")
      .arg(QDate::currentDate().toString(Qt::ISODate))
      .arg(pulses)
      .arg(subject_.device);
}

void MeasureControl::save() {
  const std::filesystem::path first =
      profile_folders_.front() / (subject_.profile.id + "-measured.json");
  QString file = prompts_.ask_profile(text(first.string()));
  if (file.isEmpty()) return;
  if (!file.endsWith(QLatin1String(".json"))) file += QLatin1String(".json");
  const std::filesystem::path path = file.toStdString();
  try {
    DeviceProfile profile = identified_profile(subject_.profile, *found_, source().toStdString());
    profile.name += ", measured";
    std::filesystem::create_directories(path.parent_path());
    write_whole(path, device_profile_text(profile));
    saved_ = read_device_profile(path);
  } catch (const std::exception& why) {
    return prompts_.report_error(QString::fromUtf8(why.what()));
  }
  devices_.add_profile(*saved_);
  emit say(QStringLiteral("Saved %1.").arg(file));
  const bool usable = std::holds_alternative<SimulatedSource>(devices_.source());
  if (dialog_) dialog_->show_saved(file, usable);
}

void MeasureControl::use() {
  if (!saved_) return;
  const DeviceProfile profile = *saved_;
  if (dialog_) dialog_->accept();
  devices_.choose(SimulatedSource{profile});
}

}  // namespace sonde::ui
