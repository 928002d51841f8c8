// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// x as single precision holds it, where the rounding counts. A function that is not inlined,
/// because g++ 12 takes double → float → double for doing nothing wherever it vectorises the two
/// together, and what is computed from the difference, or checked by it, would be wrong unseen.
float to_float(double x);

}  // namespace sonde
