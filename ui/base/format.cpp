// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/format.hpp"

#include <QRegularExpression>
#include <QStringList>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "engine/body/body.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "engine/text/printable.hpp"

namespace sonde::ui {
namespace {

constexpr int most_decimals = 6;

/// Never "-0.00".
QString fixed_text(double value, int decimals) {
  const QString text = QString::number(value, 'f', decimals);
  return text.toDouble() == 0 ? QString::number(0.0, 'f', decimals) : text;
}

/// Of a mesh file, whose folders may be named too, its name without the ending; behind that may be
/// the number of a component, as in "pair.stl:2". A name that somebody gave may have dots and
/// slashes in it, and stays.
std::string without_mesh_ending(const std::string& name) {
  const std::string before = name.substr(0, name.find_last_not_of("0123456789") + 1);
  const bool numbered = before.size() < name.size() && before.ends_with(':');
  const std::size_t length = numbered ? before.size() - 1 : name.size();
  const std::filesystem::path file(name.substr(0, length));
  return is_mesh_name(file) ? file.stem().string() + name.substr(length) : name;
}

/// Both ends of a long name, so that what is said after it has room.
QString with_its_ends(const QString& name) {
  constexpr int longest = 40, end = 15;
  if (name.size() <= longest) return name;
  int first = longest - end - 1, last = end;
  if (name.at(first - 1).isHighSurrogate()) --first;  // half a letter
  if (name.at(name.size() - last).isLowSurrogate()) --last;
  return name.left(first) + QStringLiteral("…") + name.right(last);
}

}  // namespace

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
  decimals_ = std::clamp(static_cast<int>(std::ceil(-std::log10(resolution))), 0, most_decimals);
  rounding_ = 1e-10 * radius / metres_;
}

QString LengthUnit::text(double metres) const {
  const double value = metres / metres_, size = std::abs(value);
  const double two_digits = std::pow(10, 1 - decimals_);
  // What is small but not 0 must not read as 0.
  if (size >= two_digits || size <= rounding_ || !std::isfinite(value))
    return fixed_text(value, decimals_) + ' ' + name_;
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(size)));
  return (decimals <= most_decimals ? fixed_text(value, decimals)
                                    : QString::number(value, 'e', 1)) +
         ' ' + name_;
}

QString LengthUnit::text(const Vec3& x) const {
  QStringList texts;
  for (const double each : x) texts << fixed_text(each / metres_, decimals_);
  return texts.join(QStringLiteral(", ")) + ' ' + name_;
}

QString number(double value) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  const double size = std::abs(value);
  if (size < 1e-12) return QStringLiteral("0");
  if (size < 1e-3 || size >= 1e6) return QString::number(value, 'g', 3);
  const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 5);
  return QString::number(value, 'f', decimals);
}

QString angle_text(double radians) {
  constexpr double rounding = 1e-6;  // degrees
  const double degrees = radians * 180 / std::numbers::pi;
  return number(std::abs(degrees) < rounding ? 0 : degrees) + QStringLiteral("°");
}

QString components_text(const Vec3& x) {
  const double size = x.norm();
  const int decimals =
      size > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 5) : 0;
  QStringList texts;
  for (const double each : x) {
    const QString text = QString::number(each, 'f', decimals);
    texts << (text.toDouble() == 0 ? QStringLiteral("0") : text);  // never "-0.00"
  }
  return texts.join(QStringLiteral(", "));
}

QString short_name(const Body& body) {
  QString name = text(printable(without_mesh_ending(body.name)));
  // What turns the direction of a text would turn that of the words beside the name too.
  name.remove(QRegularExpression(QStringLiteral("[\\x{202a}-\\x{202e}\\x{2066}-\\x{2069}]")));
  return with_its_ends(name);
}

QString round_figure(double value) { return QString::number(value, 'g', 6); }

double round_down_125(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {5.0, 2.0})
    if (value >= step * decade * (1 - 1e-12)) return step * decade;
  return decade;
}

QString tooltip_of(const QString& plain) {
  return plain.isEmpty() ? QString() : Qt::convertFromPlainText(plain, Qt::WhiteSpaceNormal);
}

}  // namespace sonde::ui
