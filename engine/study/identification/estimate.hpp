// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// A measured value, and the interval that contains it with 99 % probability if the model is right.
struct Estimate {
  double value = 0, low = 0, high = 0;
};

}  // namespace sonde
