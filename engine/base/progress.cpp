// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/progress.hpp"

namespace sonde {

void report(const Progress& progress, double fraction) {
  if (progress && !progress(fraction)) throw Cancelled();
}

Progress part_of(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [&progress, from, to](double f) { return progress(from + (to - from) * f); };
}

}  // namespace sonde
