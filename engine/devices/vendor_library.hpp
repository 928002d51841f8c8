// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "engine/platform/shared_library.hpp"

namespace sonde {

/// A library that only the maker of a device may distribute, and where it is searched for.
struct VendorLibraryName {
  const char* name;                    ///< name for the user: "libdhd"
  const char* maker;                   ///< "Force Dimension"
  std::span<const char* const> files;  ///< possible names, the preferred first
  const char* variable;                ///< environment variable that holds its absolute path
  const char* source;                  ///< where to get it
};

/// The state of a library, or of a service on this machine, for `sonde devices`.
struct VendorLibraryListing {
  std::string name, maker;
  std::string path{};     ///< or address; empty if there is none
  std::string version{};  ///< as it reports it; empty if it reports none
  bool usable = false;
  std::string reason{};  ///< why it is not usable, and how to get it
};

/// The system's library folders; absolute, like everything that is opened here.
std::span<const char* const> system_library_folders();

/// The file to load: the one in the environment variable, otherwise the first that exists in the
/// system folders; empty if there is none. The working folder and the loader's own search (which
/// LD_LIBRARY_PATH or an RPATH may redirect anywhere) are not used. Throws InputError if the
/// variable does not hold an absolute path, or not that of a file.
std::filesystem::path find_vendor_library(
    const VendorLibraryName& name, std::span<const char* const> folders = system_library_folders());

/// A loaded library. It stays loaded until the program ends: makers' libraries leave threads behind
/// that would otherwise run in freed memory.
class VendorLibrary {
 public:
  /// Throws InputError "FILE: reason": not a library, one for another processor, or the loader's
  /// message.
  explicit VendorLibrary(const std::filesystem::path& file);

  const std::filesystem::path& file() const { return file_; }
  /// Throws InputError, naming the symbol, if the library does not have it.
  template <class Function>
  void bind(Function*& function, const char* symbol) const {
    function = reinterpret_cast<Function*>(address_of(symbol));
  }

 private:
  void* address_of(const char* symbol) const;

  std::filesystem::path file_;
  std::optional<SharedLibrary> library_;
};

/// A text from a library; null becomes "".
inline std::string words_or_empty(const char* words) { return words ? words : ""; }

/// Why a library that was not found cannot be used: "not installed; install it from ..., or name
/// its file by the environment variable ...", or that this build supports none.
std::string why_missing(const VendorLibraryName& name, bool loads = loads_shared_libraries());

}  // namespace sonde
