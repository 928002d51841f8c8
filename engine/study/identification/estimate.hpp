// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// A measured figure, and the interval that holds it: 99 % sure where the model is right.
struct Estimate {
  double value = 0, low = 0, high = 0;
};

}  // namespace sonde
