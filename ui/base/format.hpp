// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "engine/geometry/pose.hpp"

namespace sonde {
struct Body;
}

namespace sonde::ui {

/// The length unit for a scene of this size. It is chosen once, so that numbers do not change unit
/// while one looks at them.
class LengthUnit {
 public:
  /// For bodies of this radius, m.
  explicit LengthUnit(double radius = 0.05);
  const QString& name() const { return name_; }
  double metres() const { return metres_; }
  /// "1.234 mm", with decimals that resolve about 1e-4 of the radius. A shorter length has two
  /// digits, "0.00042 mm", "3.1e-08 mm", and is 0 only below 1e-10 of the radius, which is
  /// rounding.
  QString text(double metres) const;
  /// "1.234, -0.200, 0.000 mm".
  QString text(const Vec3& x) const;

 private:
  QString name_;
  double metres_;
  int decimals_;
  double rounding_;  ///< in this unit
};

inline QString text(const std::string& utf8) { return QString::fromStdString(utf8); }
inline QString text(const char* utf8) { return QString::fromUtf8(utf8); }

/// Three significant digits (0 below 1e-12, which is rounding), '.' whatever the locale: "0.0123",
/// "12.3", "1230".
QString number(double value);

/// An angle in degrees: "12.3°", and "0°" below a millionth, which is rounding.
QString angle_text(double radians);

/// Three components with as many decimals as their length needs for three digits: "1.20, -0.04, 0".
QString components_text(const Vec3& x);

/// A tooltip that shows this text, line by line. As it stands, Qt would take some of it for markup.
QString tooltip_of(const QString& plain);

/// A body's name for users: the file's name, without folder and extension. Of a long
/// one, both ends.
QString short_name(const Body& body);

/// A figure that is already round, unchanged: "5", "0.2".
QString round_figure(double value);

/// The largest of 1, 2, 5 times a power of ten that is not above the value.
double round_down_125(double value);

}  // namespace sonde::ui
