// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/read_stream.hpp"

namespace sonde {

ReadStream open_to_read(const std::filesystem::path& file) noexcept {
  return ReadStream(std::fopen(file.string().c_str(), "rb"));
}

}  // namespace sonde
