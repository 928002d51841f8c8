// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/time_left.hpp"

#include <algorithm>
#include <cmath>

namespace sonde::ui {
namespace {

constexpr double silent = 3;         // s
constexpr double never_longer = 10;  // s without a word
constexpr double least_part = 1e-3;  // of the work: from less no time is told

}  // namespace

QString time_left_text(double seconds) {
  if (seconds < 100)
    return QStringLiteral("about %1 s left").arg(std::max(1.0, std::round(seconds)));
  return QStringLiteral("about %1 min left").arg(std::round(seconds / 60));
}

QString time_left_text(double elapsed, double part) {
  if (elapsed < silent) return {};
  if (part >= least_part) return time_left_text(elapsed / std::min(part, 1.0) - elapsed);
  if (elapsed < never_longer) return {};
  return QStringLiteral("%1 s so far, how long it takes is not known yet").arg(std::floor(elapsed));
}

}  // namespace sonde::ui
