// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/force_log.hpp"

#include <QLoggingCategory>

namespace sonde::ui {
namespace {

Q_LOGGING_CATEGORY(force, "sonde.force")

constexpr double shown_for = 4;  // s
/// s: the force fades with a time of 0.05 s, and what is over sooner is not felt as none.
constexpr double brief = 0.02;

constexpr double setting_up = 0.5;  // s, after which nothing more is put into a new scene

bool is_fault(Withheld why) {
  return why == Withheld::untrusted || why == Withheld::not_finite || why == Withheld::failed ||
         why == Withheld::stalled || why == Withheld::unsettled || why == Withheld::diverged;
}

}  // namespace

QString ForceLog::add(const Snapshot& tick) {
  if (tick.time < time_) *this = ForceLog{};
  time_ = tick.time;
  const Withheld why = tick.hand.withheld;
  if (why != Withheld::unsettled) settled_time_ = tick.time;
  if (why == Withheld::unsettled && tick.time - settled_time_ < brief) return {};
  if (is_fault(why)) {
    fault_ = why;
    fault_time_ = tick.time;
  }
  // A scene that is set up has its hand put into it: nobody has felt a force yet.
  felt_ = felt_ || !tick.wrench.force.isZero(0) || !tick.wrench.torque.isZero(0);
  if (why == Withheld::changed && (!felt_ || tick.time < setting_up)) return {};
  if (why == now_) return {};
  now_ = why;
  const QString at = QString::number(tick.time, 'f', 3);
  if (why == Withheld::nothing) {
    QString line = at + QStringLiteral(" s: the force may come in again");
    qCInfo(force).noquote() << line;
    return line;
  }
  const QString reason = QString::fromUtf8(words(why));
  if (!is_fault(why)) {  // as somebody wanted it
    QString line = QStringLiteral("%1 s: %2, so no force").arg(at, reason);
    qCInfo(force).noquote() << line;
    return line;
  }
  QString line = QStringLiteral("%1 s: no force: %2").arg(at, reason);
  qCWarning(force).noquote() << line;
  return line;
}

void ForceLog::end() {
  if (time_ > 0)
    qCInfo(force).noquote() << QStringLiteral("%1 s: %2")
                                   .arg(time_, 0, 'f', 3)
                                   .arg(QString::fromUtf8(words(Withheld::shut_down)));
  *this = ForceLog{};
}

QString ForceLog::recent(double time) const {
  if (fault_ == Withheld::nothing || time < fault_time_ || time - fault_time_ > shown_for)
    return {};
  return QStringLiteral("No force %1 s ago: %2.")
      .arg(time - fault_time_, 0, 'f', 1)
      .arg(QString::fromUtf8(words(fault_)));
}

}  // namespace sonde::ui
