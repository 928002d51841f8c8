// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sonde {

/// The parts of a ZIP file by its directory.
class ZipFile {
 public:
  /// Throws InputError where there is no directory, it is cut off, or its parts unpack to more than
  /// most_unpacked in all. `bytes` must outlive this.
  ZipFile(const std::string& file, std::string_view bytes);

  struct Part {
    std::string name;
    std::uint64_t packed = 0, unpacked = 0, header = 0;  ///< bytes; the header's place
    unsigned method = 0;                                 ///< 0: stored, 8: deflated
    std::uint64_t sum = 0;                               ///< CRC-32 of what it unpacks to
  };
  const std::vector<Part>& parts() const { return parts_; }
  /// The part of that name, the case of letters aside, as packages of this kind have it; null:
  /// none.
  const Part* find(std::string_view name) const;
  /// Throws InputError where it does not unpack to what the directory declares.
  std::string unpack(const Part& part) const;

 private:
  const std::string& file_;
  std::string_view bytes_;
  std::vector<Part> parts_;
};

/// A ZIP file of these parts, name and content, as they are.
std::string zip_of(const std::vector<std::pair<std::string, std::string_view>>& parts);

}  // namespace sonde
