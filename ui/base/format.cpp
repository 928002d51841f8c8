// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/format.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/body/body.hpp"

namespace sonde::ui {

LengthUnit::LengthUnit(double radius) {
  if (radius < 1e-3) {
    name_ = QStringLiteral("µm");
    metres_ = 1e-6;
  } else if (radius < 2) {
    name_ = QStringLiteral("mm");
    metres_ = 1e-3;
  } else {
    name_ = QStringLiteral("m");
    metres_ = 1;
  }
  const double resolution = 1e-4 * std::max(radius, 1e-12) / metres_;
  decimals_ = std::clamp(static_cast<int>(std::ceil(-std::log10(resolution))), 0, 6);
}

QString LengthUnit::text(double metres) const {
  return QString::number(metres / metres_, 'f', decimals_) + ' ' + name_;
}

QString number(double value) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  const double size = std::abs(value);
  if (size < 1e-12) return QStringLiteral("0");
  if (size < 1e-3 || size >= 1e6) return QString::number(value, 'g', 3);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 5);
  return QString::number(value, 'f', decimals);
}

QString short_name(const Body& body) {
  return QString::fromStdString(std::filesystem::path(body.name).stem().string());
}

QString round_figure(double value) { return QString::number(value, 'g', 6); }

double round_down_125(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0})
    if (value >= step * decade * (1 - 1e-12)) return step * decade;
  return decade;
}

}  // namespace sonde::ui
