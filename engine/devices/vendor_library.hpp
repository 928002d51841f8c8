// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/platform/shared_library.hpp"

namespace sonde {

/// A library that only the maker of a device may distribute, and the places where it is searched.
struct VendorLibraryName {
  const char* name;                    ///< name for the user: "libdhd"
  const char* maker;                   ///< "Force Dimension"
  std::span<const char* const> files;  ///< possible names, the preferred first
  const char* variable;                ///< environment variable that holds its absolute path
  const char* source;                  ///< where to get it
};

/// The state of a library, for `sonde devices`.
struct VendorLibraryListing {
  std::string name, maker;
  std::string path{};     ///< empty where there is none
  std::string version{};  ///< by its own word; empty where it tells none
  bool usable = false;
  std::string reason{};  ///< why it is not usable, and how to get it
};

/// The folders of the system that libraries lie in; absolute, as everything that is opened here.
std::span<const char* const> system_library_folders();

/// The file to load: the one in the environment variable, else the first that exists in the system
/// folders; empty where there is none. The working folder and the loader's own search (which
/// LD_LIBRARY_PATH or an RPATH may lead anywhere) are not used. Throws InputError where the
/// variable holds no absolute path, or not that of a file.
std::filesystem::path find_vendor_library(
    const VendorLibraryName& name, std::span<const char* const> folders = system_library_folders());

/// A loaded library. It stays loaded until the program ends: makers' libraries leave threads behind
/// that would run on in freed memory.
class VendorLibrary {
 public:
  /// Throws InputError "FILE: reason": no library, one for another processor, or the loader's word.
  explicit VendorLibrary(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  /// Throws InputError, naming the symbol, where the library has none of that name.
  template <class Function>
  void bind(Function*& function, const char* symbol) const {
    function = reinterpret_cast<Function*>(address_of(symbol));
  }

 private:
  void* address_of(const char* symbol) const;

  std::filesystem::path file_;
  std::optional<SharedLibrary> library_;
};

/// What a library answers in words; null: nothing.
inline std::string words_or_empty(const char* words) { return words ? words : ""; }

/// "Get it from ...; or name its file by the variable ..."
std::string how_to_get(const VendorLibraryName& name);

}  // namespace sonde
