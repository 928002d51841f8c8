// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/gains_text.hpp"

#include "ui/base/format.hpp"

namespace sonde::ui {

QString gains_text(const Coupling& gains) {
  if (gains.mode == Coupling::Mode::object) return QStringLiteral("k %1 N/m").arg(number(gains.k));
  if (gains.mode == Coupling::Mode::damped)
    return QStringLiteral("k %1 N/m\nb_t %2 N·s/m").arg(number(gains.k), number(gains.b_t));
  return QStringLiteral("k_t %1 N/m\nk_r %2 N·m/rad").arg(number(gains.k_t), number(gains.k_r));
}

QString gains_text(const GainGlide::Blend& gains) {
  if (gains.share >= 1) return gains_text(gains.now);
  const auto part = [](double share, const Coupling& of) {
    return QStringLiteral("%1 % of ").arg(number(100 * share)) + gains_text(of);
  };
  return part(1 - gains.share, gains.before) + QStringLiteral("\nand ") +
         part(gains.share, gains.now);
}

}  // namespace sonde::ui
