// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// Student's t that is exceeded in one case in a hundred (two-sided), for seven or more degrees of
/// freedom: within 0.5 % (the expansion of Cornish and Fisher: Abramowitz and Stegun, 26.7.5).
double student_t_99(double degrees);

}  // namespace sonde
