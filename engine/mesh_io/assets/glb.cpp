// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/glb.hpp"

#include <cstddef>

#include "engine/base/error.hpp"
#include "engine/mesh_io/assets/little_endian.hpp"

namespace sonde {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t glb_header_size = 12, chunk_header_size = 8;

}  // namespace

Glb chunks_of(const std::string& file, std::string_view bytes) {
  if (bytes.size() < glb_header_size)
    throw InputError::in(file, "the file is cut off in its header");
  if (little_endian(bytes, 4, 4) != 2)
    throw InputError::at_byte(
        file, 4, "version " + std::to_string(little_endian(bytes, 4, 4)) + " of GLB: 2 is read");
  if (little_endian(bytes, 8, 4) != bytes.size())
    throw InputError::at_byte(file, 8,
                              "the header declares " + std::to_string(little_endian(bytes, 8, 4)) +
                                  " bytes, but the file has " + std::to_string(bytes.size()));
  Glb glb;
  std::size_t at = glb_header_size;
  for (int k = 0; at < bytes.size(); ++k) {
    if (bytes.size() - at < chunk_header_size ||
        bytes.size() - at - chunk_header_size < little_endian(bytes, at, 4))
      throw InputError::at_byte(file, at, "a chunk is cut off");
    const std::string_view chunk =
        bytes.substr(at + chunk_header_size, little_endian(bytes, at, 4));
    const std::string_view type = bytes.substr(at + 4, 4);
    if (k == 0 && type != "JSON")
      throw InputError::at_byte(file, at, "the first chunk is not JSON");
    if (k == 0) glb.text = chunk;
    if (k == 1 && type == "BIN\0"sv) glb.data = chunk;
    at += chunk_header_size + chunk.size();
  }
  if (glb.text.empty()) throw InputError::in(file, "the file has no JSON chunk");
  return glb;
}

std::string glb_of(std::string_view text, std::string_view data) {
  std::string out;
  const auto add_number = [&](std::size_t value) {
    for (int k = 0; k < 4; ++k) out.push_back(static_cast<char>(value >> 8 * k));
  };
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  out.append("glTF");
  add_number(2);
  add_number(glb_header_size + 2 * chunk_header_size + padded(text.size()) + padded(data.size()));
  const auto add_chunk = [&](std::string_view bytes, std::string_view type, char filler) {
    add_number(padded(bytes.size()));
    out.append(type).append(bytes).append(padded(bytes.size()) - bytes.size(), filler);
  };
  add_chunk(text, "JSON", ' ');
  add_chunk(data, "BIN\0"sv, '\0');
  return out;
}

}  // namespace sonde
