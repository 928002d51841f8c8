// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sonde {

/// True where a person sees the standard error as it is written.
bool error_stream_is_terminal() noexcept;

}  // namespace sonde
