// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/devices/vendor_library.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

/// Word length and processor of an ELF file, from its header.
struct Architecture {
  unsigned char bits = ELFCLASSNONE;
  std::uint16_t machine = EM_NONE;
  bool operator==(const Architecture&) const = default;
};

std::optional<Architecture> architecture_of(const fs::path& file) {
  std::array<unsigned char, 20> head{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(reinterpret_cast<char*>(head.data()), head.size());
  if (!stream || std::memcmp(head.data(), ELFMAG, SELFMAG) != 0) return {};
  const bool little = head[EI_DATA] == ELFDATA2LSB;
  const unsigned first = head[18], second = head[19];
  const unsigned machine = little ? first | second << 8U : first << 8U | second;
  return Architecture{head[EI_CLASS], static_cast<std::uint16_t>(machine)};
}

std::string words(const Architecture& architecture) {
  switch (architecture.machine) {
    case EM_X86_64:
      return architecture.bits == ELFCLASS32 ? "x32" : "x86-64";
    case EM_386:
      return "32-bit x86";
    case EM_AARCH64:
      return "64-bit ARM";
    case EM_ARM:
      return "32-bit ARM";
    default:
      return "processor type " + std::to_string(architecture.machine);
  }
}

void check_architecture(const fs::path& file) {
  const std::optional<Architecture> its = architecture_of(file);
  if (!its) throw InputError::in(file.string(), "it is no shared library");
  const std::optional<Architecture> ours = architecture_of("/proc/self/exe");
  if (ours && *its != *ours)
    throw InputError::in(file.string(), "it is built for another processor (" + words(*its) +
                                            "); this program needs " + words(*ours));
}

/// The loader maps what the header promises: for a truncated file it would die of a bus error. Only
/// for files for the program's own processor.
void check_whole(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  ElfW(Ehdr) head{};
  stream.read(reinterpret_cast<char*>(&head), sizeof head);
  stream.seekg(static_cast<std::streamoff>(head.e_phoff));
  const std::uint64_t size = fs::file_size(file);
  bool whole = static_cast<bool>(stream);
  for (int i = 0; whole && i < head.e_phnum; ++i) {
    ElfW(Phdr) part{};
    stream.read(reinterpret_cast<char*>(&part), sizeof part);
    const bool inside = part.p_offset <= size && part.p_filesz <= size - part.p_offset;
    whole = stream && (part.p_type != PT_LOAD || inside);
  }
  if (!whole) throw InputError::in(file.string(), "it cannot be loaded: the file is cut off");
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::string last_loader_error() {
  const char* const error = ::dlerror();
  return error ? error : "no reason is given";
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
  check_architecture(file);
  check_whole(file);
  handle_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_) throw InputError::in(file.string(), "it cannot be loaded: " + last_loader_error());
}

void* VendorLibrary::address_of(const char* symbol) const {
  void* const address = ::dlsym(handle_, symbol);
  if (!address)
    throw InputError::in(file_.string(), std::string("it has no function ") + symbol +
                                             ": another version than this program knows");
  return address;
}

std::string how_to_get(const VendorLibraryName& name) {
  return std::string("install ") + name.name + " from " + name.source +
         ", or name its file by the environment variable " + name.variable;
}

}  // namespace sonde
