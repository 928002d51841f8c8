// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/shared_library.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;

/// Word length and processor of an ELF file, as its head says.
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

/// The loader maps what the head promises: beyond the end of a file that is cut off it dies of a
/// bus error. For the program's own processor alone.
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

std::string last_loader_error() {
  const char* const error = ::dlerror();
  return error ? error : "no reason is given";
}

}  // namespace

bool loads_shared_libraries() noexcept { return true; }

SharedLibrary::SharedLibrary(const fs::path& file) {
  check_architecture(file);
  check_whole(file);
  handle_ = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_) throw InputError::in(file.string(), "it cannot be loaded: " + last_loader_error());
}

void* SharedLibrary::find(const char* symbol) const noexcept { return ::dlsym(handle_, symbol); }

}  // namespace sonde
