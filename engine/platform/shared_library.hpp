// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace sonde {

/// Whether this build can load libraries at all; if not, SharedLibrary always throws.
bool loads_shared_libraries() noexcept;

/// A library that is loaded while the program runs. It stays loaded until the program ends.
class SharedLibrary {
 public:
  /// Throws InputError "FILE: reason": no library, one for another processor, one that is cut off,
  /// or the loader's word.
  explicit SharedLibrary(const std::filesystem::path& file);

  /// The address of a function or an object; null where it has none of that name.
  void* find(const char* symbol) const noexcept;

 private:
  void* handle_ = nullptr;
};

}  // namespace sonde
