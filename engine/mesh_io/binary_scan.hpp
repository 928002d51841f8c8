// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/mesh_io/plain_text.hpp"
#include "engine/mesh_io/remarks.hpp"

namespace sonde {

/// Walks through the numbers of a binary mesh file and knows the byte of each for error messages.
class BinaryScanner {
 public:
  BinaryScanner(const std::string& file, std::string_view bytes, std::size_t start,
                std::endian order, const Progress& progress)
      : file_(file),
        bytes_(bytes),
        at_(start),
        swap_(order != std::endian::native),
        progress_(progress) {}

  std::size_t position() const { return at_; }
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// The next number, passed over; there must be so many bytes left (see need).
  template <class T>
  T take() {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes_.data() + at_, sizeof(T));
    if (swap_) std::reverse(raw, raw + sizeof(T));
    at_ += sizeof(T);
    return std::bit_cast<T>(raw);
  }
  void skip(std::uint64_t n) { at_ += n; }

  /// Refuses the file where it has fewer bytes left; `inside` says of what.
  void need(std::uint64_t n, const auto& inside) const {
    if (bytes_left() < n) refuse_at(bytes_.size(), "the file ends inside " + inside());
  }
  /// Call it for each of many items: it reports progress now and then.
  void report(std::uint64_t item) const {
    if ((item & 0xffff) == 0 && progress_ &&
        !progress_(static_cast<double>(at_) / static_cast<double>(bytes_.size())))
      throw Cancelled();
  }

  /// Refuses the file where more follows; bytes that say nothing get a remark.
  void check_end(Remarks& remarks) const {
    if (bytes_left() == 0) return;
    if (!is_padding(bytes_.substr(at_)))
      refuse_at(at_, std::to_string(bytes_left()) + " bytes more than the header declares");
    remark_on_bytes(remarks, bytes_left(), "the mesh, zeros or blanks,");
  }

  [[noreturn]] void refuse_at(std::size_t byte, const std::string& reason) const {
    throw InputError::at_byte(file_, byte, reason);
  }

 private:
  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_;
  bool swap_;
  const Progress& progress_;
};

}  // namespace sonde
