// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// x rounded to single precision, for code that depends on this rounding. It is not inlined,
/// because g++ 12 removes double → float → double where it vectorises both together; a result that
/// uses the difference would then be wrong without notice.
float to_float(double x);

}  // namespace sonde
