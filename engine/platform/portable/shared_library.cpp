// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/shared_library.hpp"

#include "engine/base/error.hpp"

namespace sonde {

SharedLibrary::SharedLibrary(const std::filesystem::path& file) {
  throw InputError::in(file.string(), "it cannot be loaded: no makers' libraries on this system");
}

void* SharedLibrary::find(const char*) const noexcept { return handle_; }

}  // namespace sonde
