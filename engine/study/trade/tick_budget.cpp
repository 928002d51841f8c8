// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/tick_budget.hpp"

#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {

Budget tick_budget(const ServoSettings& servo, const Pair& pair, Method method,
                   const Calibration& calibration) {
  Budget budget = servo.budget;
  if (!(servo.accuracy > 0)) return budget;
  const AccuracyCurve curve(calibration, Answers::tick, method, bool(pair.sketches()));
  budget.microseconds = budget_us({.accuracy = servo.accuracy}, curve);
  return budget;
}

}  // namespace sonde
