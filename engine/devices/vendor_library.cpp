// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/vendor_library.hpp"

#include <cstdlib>
#include <system_error>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

}  // namespace

std::span<const char* const> system_library_folders() {
  static constexpr const char* folders[] = {"/usr/local/lib", "/usr/lib/x86_64-linux-gnu",
                                            "/usr/lib/aarch64-linux-gnu", "/usr/lib64", "/usr/lib"};
  return folders;
}

fs::path find_vendor_library(const VendorLibraryName& name, std::span<const char* const> folders) {
  // An empty value counts as none, since a shell clears a variable for one command in this way.
  if (const char* asked = std::getenv(name.variable); asked && *asked) {
    const std::string value = asked;
    if (!fs::path(value).is_absolute())
      throw InputError::in(value, std::string("the environment variable ") + name.variable +
                                      " must hold an absolute path");
    if (!is_file(value))
      throw InputError::in(value, std::string("there is no such file; the environment variable ") +
                                      name.variable + " names it");
    return value;
  }
  for (const char* folder : folders)
    for (const char* file : name.files)
      if (fs::path path = fs::path(folder) / file; path.is_absolute() && is_file(path)) return path;
  return {};
}

VendorLibrary::VendorLibrary(const fs::path& file) : file_(file) {
  if (!file.is_absolute()) throw InputError::in(file.string(), "its path is not absolute");
  library_.emplace(file);
}

void* VendorLibrary::address_of(const char* symbol) const {
  void* const address = library_->find(symbol);
  if (!address)
    throw InputError::in(file_.string(), std::string("it has no function ") + symbol +
                                             ": another version than this program knows");
  return address;
}

std::string why_missing(const VendorLibraryName& name, bool loads) {
  if (!loads) return "not supported: this build of Sonde loads no makers' libraries";
  return std::string("not installed; install ") + name.name + " from " + name.source +
         ", or name its file by the environment variable " + name.variable;
}

}  // namespace sonde
