// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/recommendation_text.hpp"

#include <QStringList>

#include "engine/study/tuning/tuning_words.hpp"
#include "ui/base/format.hpp"
#include "ui/tuning/present_contact.hpp"

namespace sonde::ui {

QString recommendation_text(const TuningResults& results, GainAxis axis) {
  QStringList lines;
  for (const std::string& words : axis_in_words(results, axis)) {
    const QString line = text(words);
    // A gain's key is a name, and stays small.
    const bool first_of_gains = lines.isEmpty() && line.startsWith(QLatin1Char('k'));
    lines << (first_of_gains ? QStringLiteral("Recommended: ") + line
                             : line.left(1).toUpper() + line.mid(1)) +
                 QLatin1Char('.');
  }
  return lines.join('\n');
}

QString margin_text(const TuningResults& results, GainAxis axis, double stiffness, double damping) {
  const auto allowed = allowed_at(results, axis, damping);
  return allowed ? allowed_text(*allowed, axis, stiffness) : QString();
}

}  // namespace sonde::ui
