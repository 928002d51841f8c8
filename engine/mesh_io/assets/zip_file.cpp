// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/zip_file.hpp"

#include <zlib.h>

#include <algorithm>
#include <new>

#include "engine/base/error.hpp"
#include "engine/mesh_io/assets/asset_readers.hpp"
#include "engine/mesh_io/assets/little_endian.hpp"
#include "engine/text/json_checks.hpp"

namespace sonde {
namespace {

// APPNOTE.TXT of the format: 4.3.7 local header, 4.3.12 directory, 4.3.16 its end.
constexpr std::size_t end_size = 22, entry_size = 46, local_header_size = 30;
constexpr std::size_t locator_size = 20, end64_size = 56;  // 4.3.15, 4.3.14
constexpr std::size_t longest_comment = 65535;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// What does not fit into 32 bits stands in an extra field, in this order (4.5.3).
void read_large_numbers(std::string_view bytes, std::uint64_t at, std::uint64_t size,
                        ZipFile::Part& part) {
  constexpr std::uint64_t elsewhere = 0xffffffff, id = 1;
  if (at > bytes.size() || bytes.size() - at < size) return;
  for (const std::uint64_t end = at + size; end - at >= 4;) {
    const std::uint64_t its = little_endian(bytes, at + 2, 2), begin = at + 4;
    if (end - begin < its) return;
    std::uint64_t next = begin;
    if (little_endian(bytes, at, 2) == id)
      for (std::uint64_t* number : {&part.unpacked, &part.packed, &part.header})
        if (*number == elsewhere && begin + its - next >= 8) {
          *number = little_endian(bytes, next, 8);
          next += 8;
        }
    at = begin + its;
  }
}

std::uint64_t crc_of(std::string_view bytes) {
  return crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

/// Shorter than `size` where it does not unpack to that.
std::string inflated(std::string_view packed, std::uint64_t size) {
  std::string out(size, '\0');
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(size);
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END) out.clear();
  out.resize(std::min<std::size_t>(out.size(), stream.total_out));
  return out;
}

}  // namespace

ZipFile::ZipFile(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {
  using namespace std::string_view_literals;
  const std::size_t end = bytes.rfind("PK\5\6"sv);
  if (end == bytes.npos || bytes.size() - end < end_size ||
      bytes.size() - end > end_size + longest_comment)
    throw InputError::in(file, "not a ZIP file, or cut off: it has no directory");
  std::uint64_t count = little_endian(bytes, end + 10, 2), at = little_endian(bytes, end + 16, 4);
  if (end >= locator_size && bytes.substr(end - locator_size, 4) == "PK\6\7"sv) {
    const std::uint64_t end64 = little_endian(bytes, end - locator_size + 8, 8);
    if (end64 > bytes.size() || bytes.size() - end64 < end64_size)
      throw InputError::in(file, "the directory of the ZIP file is cut off");
    count = little_endian(bytes, end64 + 32, 8);
    at = little_endian(bytes, end64 + 48, 8);
  }
  std::uint64_t unpacked = 0;
  for (std::uint64_t k = 0; k < count; ++k) {
    if (at > bytes.size() || bytes.size() - at < entry_size || bytes.substr(at, 4) != "PK\1\2"sv)
      throw InputError::at_byte(file, at, "the directory of the ZIP file is damaged");
    const std::uint64_t name = little_endian(bytes, at + 28, 2);
    if (bytes.size() - at - entry_size < name)
      throw InputError::at_byte(file, at, "the directory of the ZIP file is cut off");
    parts_.push_back({.name = std::string(bytes.substr(at + entry_size, name)),
                      .packed = little_endian(bytes, at + 20, 4),
                      .unpacked = little_endian(bytes, at + 24, 4),
                      .header = little_endian(bytes, at + 42, 4),
                      .method = static_cast<unsigned>(little_endian(bytes, at + 10, 2)),
                      .sum = little_endian(bytes, at + 16, 4)});
    read_large_numbers(bytes, at + entry_size + name, little_endian(bytes, at + 30, 2),
                       parts_.back());
    if (parts_.back().unpacked > most_unpacked) unpacked = most_unpacked;
    unpacked += parts_.back().unpacked;
    if (unpacked > most_unpacked)
      throw InputError::in(
          file, "its parts unpack to more than " + std::to_string(most_unpacked >> 20) + " MiB");
    at += entry_size + name + little_endian(bytes, at + 30, 2) + little_endian(bytes, at + 32, 2);
  }
}

const ZipFile::Part* ZipFile::find(std::string_view name) const {
  const auto found = std::ranges::find_if(parts_, [&](const Part& part) {
    return std::ranges::equal(part.name, name, {}, lower, lower);
  });
  return found == parts_.end() ? nullptr : &*found;
}

std::string ZipFile::unpack(const Part& part) const {
  const auto refuse = [&](const std::string& why) {
    return InputError::at_byte(file_, part.header, "the part " + in_quotes(part.name) + " " + why);
  };
  if (part.header > bytes_.size() || bytes_.size() - part.header < local_header_size)
    throw refuse("is cut off");
  const std::uint64_t at = part.header + local_header_size +
                           little_endian(bytes_, part.header + 26, 2) +
                           little_endian(bytes_, part.header + 28, 2);
  if (at > bytes_.size() || bytes_.size() - at < part.packed) throw refuse("is cut off");
  const std::string_view packed = bytes_.substr(at, part.packed);
  // Deflate makes no more than 1032 bytes of one.
  if (part.unpacked / 1032 > part.packed + 1) throw refuse("declares more than it can unpack to");
  std::string out;
  if (part.method == 8)
    out = inflated(packed, part.unpacked);
  else if (part.method == 0)
    out = packed;
  else
    throw refuse("is packed in a way that is not read");
  if (out.size() != part.unpacked || crc_of(out) != part.sum)
    throw refuse("does not unpack to what the directory declares");
  return out;
}

std::string zip_of(const std::vector<std::pair<std::string, std::string_view>>& parts) {
  std::string out, directory;
  const auto number = [](std::uint64_t value, int size) {
    std::string bytes;
    for (; size > 0; --size, value >>= 8) bytes.push_back(static_cast<char>(value));
    return bytes;
  };
  constexpr int version = 10;  // of what is needed to read it
  for (const auto& [name, content] : parts) {
    // From the version on, as in both headers: flags, method and time are none.
    const std::string common = number(version, 2) + number(0, 8) + number(crc_of(content), 4) +
                               number(content.size(), 4) + number(content.size(), 4) +
                               number(name.size(), 2) + number(0, 2);
    directory.append("PK\1\2").append(number(version, 2)).append(common).append(number(0, 10));
    directory.append(number(out.size(), 4)).append(name);
    out.append("PK\3\4").append(common).append(name).append(content);
  }
  const std::size_t at = out.size();
  out.append(directory).append("PK\5\6").append(number(0, 4));
  out.append(number(parts.size(), 2)).append(number(parts.size(), 2));
  return out.append(number(directory.size(), 4)).append(number(at, 4)).append(number(0, 2));
}

}  // namespace sonde
