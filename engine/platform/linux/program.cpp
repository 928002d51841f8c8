// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/program.hpp"

namespace sonde {

std::vector<std::string> begin_program(int count, const char* const* arguments) {
  return {arguments + (count > 0 ? 1 : 0), arguments + count};
}

std::filesystem::path program_file() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

}  // namespace sonde
