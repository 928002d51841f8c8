// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/source_words.hpp"

#include <QStringList>
#include <optional>
#include <string>

#include "engine/haptics/safety/borne_gains.hpp"
#include "ui/base/format.hpp"
#include "ui/devices/device_control.hpp"

namespace sonde::ui {
namespace {

QString with_unit(double value, const char* unit) { return number(value) + ' ' + text(unit); }

QString capabilities(const DeviceCapabilities& can) {
  QStringList parts{can.position ? QStringLiteral("tells positions")
                                 : QStringLiteral("tells deflections")};
  const QString force = QStringLiteral("force to ") + with_unit(can.max_force, "N");
  if (!can.force)
    parts << QStringLiteral("no force");
  else if (can.max_torque > 0)
    parts << force + QStringLiteral(" and ") + with_unit(can.max_torque, "N·m");
  else
    parts << force << QStringLiteral("no torque: the coupling's torque is shown, not felt");
  if (can.buttons > 0) parts << QStringLiteral("%1 buttons").arg(can.buttons);
  return parts.join(QStringLiteral(", "));
}

/// Empty where every figure has a source.
QString assumed_of(const DeviceProfile& profile) {
  QStringList assumed;
  for (const std::string& key : assumed_keys(profile)) assumed << text(key).replace('_', ' ');
  return assumed.isEmpty()
             ? QString()
             : QStringLiteral(" Assumed: ") + assumed.join(QStringLiteral(", ")) + QLatin1Char('.');
}

/// By what it is judged which gains wait in a contact.
QString words_of_judgement(const std::optional<DeviceProfile>& profile) {
  if (profile)
    return QStringLiteral("Gains that would be unstable in a contact wait, by the profile %1.")
               .arg(text(profile->id)) +
           assumed_of(*profile);
  const DeviceTraits least = assumed_traits();
  return QStringLiteral(
             "Gains that would be unstable in a contact wait. No profile has its name: it is taken "
             "to damp by %1 and to be %2 late, the least and the latest of the profiles.")
      .arg(with_unit(least.damping, "N·s/m"), with_unit(1e3 * least.delay, "ms"));
}

}  // namespace

QString words_of(const DeviceProfile& profile) {
  const QString limits =
      QStringLiteral("Simulated: %1 and %2, %3, %4 late. The mouse moves the hand on it.")
          .arg(with_unit(profile.max_force.value, "N"), with_unit(profile.max_torque.value, "N·m"),
               with_unit(profile.mass.value, "kg"), with_unit(1e3 * profile.delay.value, "ms"));
  return limits + assumed_of(profile);
}

QString words_of(const SourceReport& report) {
  const DeviceStatus& status = report.device;
  QStringList lines;
  if (!status.path.empty()) lines << text(status.path) + ": " + capabilities(status.capabilities);
  if (!status.reason.empty()) lines << text(status.reason);
  if (*status.scheduling != 0) lines << "Its thread has " + text(status.scheduling);
  if (*status.wakefulness != 0) lines << "While it runs, " + text(status.wakefulness);
  if (status.capabilities.force && status.capabilities.position)
    lines << words_of_judgement(report.profile);
  return lines.join(QStringLiteral("\n"));
}

}  // namespace sonde::ui
