// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

/// What libFuzzer calls, with an input of its making.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace sonde::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// An invariant that must hold whatever the input: ends the program where it does not.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

/// A file of these bytes, for what reads files alone; gone with the object.
class InputFile {
 public:
  InputFile(std::string_view bytes, const char* extension)
      : path_(std::filesystem::temp_directory_path() /
              ("sonde-fuzz-" + std::to_string(::getpid()) + extension)) {
    std::ofstream(path_, std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Takes numbers off the bytes of an input; zeros once they are used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  /// From 0 to most.
  std::size_t count(std::size_t most) { return byte() % (most + 1); }
  /// On a grid of 1/16 from -8 to 8: so that contacts are often exact.
  double on_grid() { return static_cast<std::int8_t>(byte()) / 16.0; }
  template <class T>
  T raw() {
    T value{};
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      const std::uint8_t b = byte();
      std::memcpy(reinterpret_cast<char*>(&value) + i, &b, 1);
    }
    return value;
  }
  bool empty() const { return size_ == 0; }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

}  // namespace sonde::fuzz
