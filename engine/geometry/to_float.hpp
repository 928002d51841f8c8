// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// x in single precision, where the rounding counts. It is not inlined, because g++ 12 removes
/// double → float → double where it vectorises both together. A result computed from the
/// difference, or checked by it, would then be wrong without notice.
float to_float(double x);

}  // namespace sonde
