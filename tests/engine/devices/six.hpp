// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/devices/device_sample.hpp"

namespace sonde::test {

/// One value for each axis: three of translation, three of rotation.
inline SixAxes six(double a, double b, double c, double d, double e, double f) {
  SixAxes axes;
  axes << a, b, c, d, e, f;
  return axes;
}

}  // namespace sonde::test
