// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde::test {

/// The time of a tick at 1 kHz, s.
inline constexpr double dt = 1e-3;

}  // namespace sonde::test
