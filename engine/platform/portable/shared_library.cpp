// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/shared_library.hpp"

#include "engine/base/error.hpp"

namespace sonde {

bool loads_shared_libraries() noexcept { return false; }

SharedLibrary::SharedLibrary(const std::filesystem::path& file) {
  throw InputError::in(file.string(),
                       "it cannot be loaded: this build of Sonde supports no makers' libraries");
}

void* SharedLibrary::find(const char*) const noexcept { return handle_; }

}  // namespace sonde
