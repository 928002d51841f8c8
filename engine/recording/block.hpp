// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/recording/recorded_tick.hpp"

namespace sonde {

enum class BlockKind { ticks, searches, end };

/// The header of a block, before its content: 40 bytes, little-endian.
///
///     0 kind, "TICK", "SRCH" or "END "    4 bytes of content, compressed    8 the same,
///     decompressed 12 rows    16 time of the first row, s    24 of the last one    32 zero 36
///     CRC-32 of these 36 bytes and the compressed content
struct BlockHead {
  static constexpr std::size_t size = 40;
  BlockKind kind = BlockKind::end;
  std::uint32_t packed = 0;  ///< bytes of compressed content
  std::uint32_t raw = 0;     ///< bytes of decompressed content
  std::uint32_t rows = 0;
  double first = 0;  ///< s
  double last = 0;
  std::uint32_t crc = 0;
};

/// Compressed blocks with their headers, as stored in a file.
std::string tick_block(std::span<const Snapshot> ticks);
std::string search_block(std::span<const RecordedSearch> searches);
/// The last block: a recording that ends with it is whole. It stores the number of ticks, at most
/// 2^32 − 1.
std::string end_block(std::uint64_t ticks);

/// The header of a block. Throws std::invalid_argument if it is invalid.
BlockHead head_of(std::string_view bytes);
/// The decompressed content of a block; `bytes` are header and content. Throws
/// std::invalid_argument if the checksum or the size does not match.
std::string content_of(const BlockHead& head, std::string_view bytes);
/// Checks only the checksum.
bool is_sound(const BlockHead& head, std::string_view bytes);

}  // namespace sonde
