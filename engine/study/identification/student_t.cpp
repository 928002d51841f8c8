// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/student_t.hpp"

namespace sonde {

double student_t_99(double degrees) {
  constexpr double x = 2.5758293035489004;  // of the normal distribution
  constexpr double x3 = x * x * x, x5 = x3 * x * x, x7 = x5 * x * x, x9 = x7 * x * x;
  const double n = degrees;
  return x + (x3 + x) / (4 * n) + (5 * x5 + 16 * x3 + 3 * x) / (96 * n * n) +
         (3 * x7 + 19 * x5 + 17 * x3 - 15 * x) / (384 * n * n * n) +
         (79 * x9 + 776 * x7 + 1482 * x5 - 1920 * x3 - 945 * x) / (92160 * n * n * n * n);
}

}  // namespace sonde
