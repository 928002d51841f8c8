// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/present_contact.hpp"

#include <cmath>

#include "engine/study/stability/contact_situations.hpp"
#include "engine/study/tuning/tuning_words.hpp"
#include "ui/base/format.hpp"
#include "ui/tuning/stability_map.hpp"

namespace sonde::ui {

std::string kind_of_contact(const Separation& separation) {
  const bool holds = separation.status == Status::penetrating && separation.contacts.size > 0;
  return holds ? name_of(contact_kind(separation)) : std::string();
}

QString distance_text(double stiffness, double allowed) {
  constexpr double to_three_digits = 1.005;  // "1.00 times" would say nothing, of either side
  if (!std::isfinite(allowed) || stiffness <= 0) return {};
  if (allowed <= 0) return QStringLiteral("no stiffness is good");
  if (stiffness > to_three_digits * allowed)
    return QStringLiteral("%1 times too stiff").arg(number(stiffness / allowed));
  if (allowed > to_three_digits * stiffness)
    return QStringLiteral("could be %1 times as stiff").arg(number(allowed / stiffness));
  return QStringLiteral("as stiff as it may be");
}

QString allowed_text(const GainLimit& allowed, GainAxis axis, double stiffness) {
  const QString limited = text(limit_in_words(allowed));
  if (!(allowed.stiffness > 0))
    return QStringLiteral("the study allows no stiffness, %1").arg(limited);
  return QStringLiteral("the study allows %1 %2, %3: %4")
      .arg(number(allowed.stiffness), stiffness_unit(axis), limited,
           distance_text(stiffness, allowed.stiffness));
}

}  // namespace sonde::ui
