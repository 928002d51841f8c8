// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/status_line.hpp"

#include <variant>

#include "ui/base/format.hpp"
#include "ui/shell/timing_text.hpp"

namespace sonde::ui {

StatusLine::StatusLine(QStatusBar& bar)
    : happening_(new ElidedLabel(&bar)), source_(new QLabel(&bar)), rates_(new QLabel(&bar)) {
  happening_->setObjectName(QStringLiteral("what_happens"));
  rates_->setObjectName(QStringLiteral("rates"));
  source_->setObjectName(QStringLiteral("device_status"));
  source_->setTextFormat(Qt::PlainText);  // a device names itself
  bar.addWidget(happening_, 1);
  bar.addPermanentWidget(source_);
  bar.addPermanentWidget(rates_);
}

void StatusLine::show_happening(const QString& what) { happening_->show_text(what); }

void StatusLine::show_rates(const Instant& now, Session& session, double frames_per_second,
                            bool simplified) {
  const Snapshot& tick = now.snapshot;
  rates_->setToolTip(timing_text(session.timing()));
  if (!now.live && tick.tick_us == 0) return rates_->setText(QStringLiteral("run with no clock"));
  rates_->setText(QStringLiteral("servo %1 Hz, tick %2 µs, view %3 frames/s%4")
                      .arg(tick.paused ? 0 : tick.rate_hz, 0, 'f', 0)
                      .arg(tick.tick_us, 0, 'f', 0)
                      .arg(frames_per_second, 0, 'f', 0)
                      .arg(simplified ? QStringLiteral(", simplified while moving") : QString()));
}

void StatusLine::show_source(const InputSource& source, const SourceReport& report) {
  QString text = QString::fromStdString(name_of(source));
  if (std::holds_alternative<ConnectedSource>(source)) {
    text += QStringLiteral(": ") + QLatin1String(name_of(report.device.state));
    if (report.clutch_open) text += QStringLiteral(", clutch open");
    if (!report.device.reason.empty())
      text += QStringLiteral(" (%1)").arg(QString::fromStdString(report.device.reason));
  }
  source_->setToolTip(tooltip_of(text));
  constexpr int longest = 70;  // characters
  source_->setText(text.size() <= longest ? text : text.left(longest - 1) + QChar(0x2026));
}

}  // namespace sonde::ui
