// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/block.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sonde {
namespace {

constexpr std::array<std::string_view, 3> tags{"TICK", "SRCH", "END "};
constexpr std::size_t tag_size = 4, crc_at = 36;
/// More than any valid block; a header with a larger size is invalid.
constexpr std::uint32_t most_bytes = 1u << 28;

std::string compressed(std::string_view content) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  std::string out(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                reinterpret_cast<const Bytef*>(content.data()), static_cast<uLong>(content.size()),
                Z_BEST_SPEED) != Z_OK)
    throw std::bad_alloc();
  out.resize(size);
  return out;
}

std::uint32_t crc_of(std::string_view head, std::string_view content) {
  const auto add = [](uLong crc, std::string_view part) {
    return crc32_z(crc, reinterpret_cast<const Bytef*>(part.data()), part.size());
  };
  return static_cast<std::uint32_t>(add(add(crc32_z(0, nullptr, 0), head), content));
}

void append_time(std::string& out, double time) {
  const auto bits = std::bit_cast<std::uint64_t>(time);
  append_planes(out, {&bits, 1}, sizeof bits);
}

double take_time(std::string_view& in) {
  return std::bit_cast<double>(take_planes(in, 1, sizeof(double)).front());
}

std::string block(const BlockHead& head, std::string_view content) {
  const std::string packed = content.empty() ? std::string() : compressed(content);
  std::string out(tags.at(static_cast<std::size_t>(head.kind)));
  append_count(out, static_cast<std::uint32_t>(packed.size()));
  append_count(out, static_cast<std::uint32_t>(content.size()));
  append_count(out, head.rows);
  append_time(out, head.first);
  append_time(out, head.last);
  append_count(out, 0);
  append_count(out, crc_of(out, packed));
  return out + packed;
}

template <class Row>
std::size_t row_width(std::span<const Column<Row>> columns) {
  std::size_t sum = 0;
  for (const Column<Row>& column : columns) sum += width(column.as);
  return sum;
}

void check_rows(const BlockHead& head) {
  const std::size_t row =
      head.kind == BlockKind::ticks ? row_width(tick_columns()) : row_width(search_columns());
  if (head.rows == 0 || head.rows > head.raw / row)
    throw std::invalid_argument("a block has no rows, or more than it can hold");
  if (!std::isfinite(head.first) || !std::isfinite(head.last) || head.last < head.first)
    throw std::invalid_argument("the times of a block are not finite, or fall");
}

}  // namespace

std::string tick_block(std::span<const Snapshot> ticks) {
  if (ticks.empty()) return {};
  return block({.kind = BlockKind::ticks,
                .rows = static_cast<std::uint32_t>(ticks.size()),
                .first = ticks.front().time,
                .last = ticks.back().time},
               tick_content(ticks));
}

std::string search_block(std::span<const RecordedSearch> searches) {
  if (searches.empty()) return {};
  return block({.kind = BlockKind::searches,
                .rows = static_cast<std::uint32_t>(searches.size()),
                .first = searches.front().time,
                .last = searches.back().time},
               search_content(searches));
}

std::string end_block(std::uint64_t ticks) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
  return block({.kind = BlockKind::end, .rows = static_cast<std::uint32_t>(std::min(ticks, most))},
               {});
}

BlockHead head_of(std::string_view bytes) {
  if (bytes.size() < BlockHead::size) throw std::invalid_argument("a block ends within its head");
  const auto tag = std::ranges::find(tags, bytes.substr(0, tag_size));
  if (tag == tags.end()) throw std::invalid_argument("no block begins here");
  bytes.remove_prefix(tag_size);
  BlockHead head;
  head.kind = static_cast<BlockKind>(tag - tags.begin());
  head.packed = take_count(bytes);
  head.raw = take_count(bytes);
  head.rows = take_count(bytes);
  head.first = take_time(bytes);
  head.last = take_time(bytes);
  take_count(bytes);
  head.crc = take_count(bytes);
  if (head.packed > most_bytes || head.raw > most_bytes)
    throw std::invalid_argument("a block is larger than there can be one");
  if (head.kind != BlockKind::end) check_rows(head);
  return head;
}

bool is_sound(const BlockHead& head, std::string_view bytes) {
  return bytes.size() == BlockHead::size + head.packed &&
         crc_of(bytes.substr(0, crc_at), bytes.substr(BlockHead::size)) == head.crc;
}

std::string content_of(const BlockHead& head, std::string_view bytes) {
  if (!is_sound(head, bytes)) throw std::invalid_argument("the checksum of a block is wrong");
  std::string out(head.raw, '\0');
  if (out.empty()) return out;
  const std::string_view packed = bytes.substr(BlockHead::size);
  uLongf size = head.raw;
  const int result =
      uncompress(reinterpret_cast<Bytef*>(out.data()), &size,
                 reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size()));
  if (result != Z_OK || size != head.raw)
    throw std::invalid_argument("a block cannot be uncompressed");
  return out;
}

}  // namespace sonde
