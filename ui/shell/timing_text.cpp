// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/timing_text.hpp"

#include <QStringList>

namespace sonde::ui {
namespace {

QString line(const char* what, const TimeHistogram& times) {
  return QStringLiteral("%1: %2, %3, %4, %5 µs")
      .arg(QLatin1String(what))
      .arg(times.quantile(0.5), 0, 'f', 0)
      .arg(times.quantile(0.99), 0, 'f', 0)
      .arg(times.quantile(0.999), 0, 'f', 0)
      .arg(times.largest, 0, 'f', 0);
}

}  // namespace

QString timing_text(const ServoTiming& timing) {
  if (timing.ticks == 0) return QStringLiteral("No tick yet.");
  QStringList lines{QStringLiteral("Median, p99, p99.9 and the longest since the start:"),
                    line("period", timing.period), line("tick", timing.tick),
                    line("geometry", timing.geometry), line("age of the rows", timing.age)};
  lines << QStringLiteral("late: %1 of %2 ticks").arg(timing.late).arg(timing.ticks);
  lines << QStringLiteral("in step: %1 %")
               .arg(100.0 * double(timing.in_step) / double(timing.ticks), 0, 'f', 1);
  for (const char* words :
       {timing.real_time.scheduling, timing.real_time.memory, timing.real_time.processor})
    if (*words != 0) lines << QString::fromUtf8(words);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace sonde::ui
