// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

namespace sonde {

struct CloseStream {
  void operator()(std::FILE* stream) const noexcept { std::fclose(stream); }
};
using ReadStream = std::unique_ptr<std::FILE, CloseStream>;

/// The name by which open_to_read() opens the standard input.
inline constexpr const char* standard_input_name = "/dev/stdin";

/// Opens a file or a pipe from its first byte on; null where that fails, and errno says why.
ReadStream open_to_read(const std::filesystem::path& file) noexcept;

}  // namespace sonde
