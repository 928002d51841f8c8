// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/zip_file.hpp"

#include <zlib.h>

#include <algorithm>

#include "engine/base/error.hpp"
#include "engine/mesh_io/assets/asset_readers.hpp"
#include "engine/mesh_io/assets/little_endian.hpp"

namespace sonde {
namespace {

// APPNOTE.TXT of the format: 4.3.7 local header, 4.3.12 directory, 4.3.16 its end.
constexpr std::size_t end_size = 22, entry_size = 46, local_header_size = 30;
constexpr std::size_t longest_comment = 65535;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

ZipFile::ZipFile(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) {
  using namespace std::string_view_literals;
  const std::size_t end = bytes.rfind("PK\5\6"sv);
  if (end == bytes.npos || bytes.size() - end < end_size ||
      bytes.size() - end > end_size + longest_comment)
    throw InputError::in(file, "not a ZIP file, or cut off: it has no directory");
  const std::uint64_t count = little_endian(bytes, end + 10, 2);
  std::uint64_t at = little_endian(bytes, end + 16, 4), unpacked = 0;
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
                      .method = static_cast<unsigned>(little_endian(bytes, at + 10, 2))});
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
    return InputError::at_byte(file_, part.header, "the part \"" + part.name + "\" " + why);
  };
  if (part.header > bytes_.size() || bytes_.size() - part.header < local_header_size)
    throw refuse("is cut off");
  const std::uint64_t at = part.header + local_header_size +
                           little_endian(bytes_, part.header + 26, 2) +
                           little_endian(bytes_, part.header + 28, 2);
  if (at > bytes_.size() || bytes_.size() - at < part.packed) throw refuse("is cut off");
  const std::string_view packed = bytes_.substr(at, part.packed);
  if (part.method == 0 && part.packed == part.unpacked) return std::string(packed);
  if (part.method != 8) throw refuse("is packed in a way that is not read");
  std::string out(part.unpacked, '\0');
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
  stream.avail_in = static_cast<uInt>(packed.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END || stream.avail_out != 0)
    throw refuse("does not unpack to the size that the directory declares");
  return out;
}

}  // namespace sonde
