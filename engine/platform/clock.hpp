// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace sonde {

/// ns of a clock that nobody sets, from an unspecified start.
std::int64_t monotonic_ns() noexcept;

/// Returns when that clock shows `due`, or later. For a loop with deadlines: it neither allocates
/// nor spins.
void sleep_until_ns(std::int64_t due) noexcept;

}  // namespace sonde
