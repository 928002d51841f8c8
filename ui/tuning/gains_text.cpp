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

}  // namespace sonde::ui
