// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/recording/columns.hpp"

#include <bit>
#include <stdexcept>

namespace sonde {
namespace {

constexpr unsigned byte_bits = 8;
constexpr std::uint64_t byte_mask = 0xff;

[[noreturn]] void fail() { throw std::invalid_argument("it holds less than it says"); }

}  // namespace

const char* name_of(Stored as) {
  switch (as) {
    case Stored::f64:
      return "f64";
    case Stored::f32:
      return "f32";
    case Stored::u64:
      return "u64";
    case Stored::u32:
      return "u32";
    case Stored::u8:
      return "u8";
  }
  return "";
}

std::size_t width(Stored as) noexcept {
  switch (as) {
    case Stored::f64:
    case Stored::u64:
      return 8;
    case Stored::f32:
    case Stored::u32:
      return 4;
    case Stored::u8:
      return 1;
  }
  return 0;
}

std::uint64_t bits_of(double value, Stored as) noexcept {
  switch (as) {
    case Stored::f64:
      return std::bit_cast<std::uint64_t>(value);
    case Stored::f32:
      return std::bit_cast<std::uint32_t>(static_cast<float>(value));
    case Stored::u64:
      return field_of<std::uint64_t>(value);
    case Stored::u32:
      return field_of<std::uint32_t>(value);
    case Stored::u8:
      return field_of<std::uint8_t>(value);
  }
  return 0;
}

double value_of(std::uint64_t bits, Stored as) noexcept {
  switch (as) {
    case Stored::f64:
      return std::bit_cast<double>(bits);
    case Stored::f32:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case Stored::u64:
    case Stored::u32:
    case Stored::u8:
      return static_cast<double>(bits);
  }
  return 0;
}

void append_planes(std::string& out, std::span<const std::uint64_t> bits, std::size_t width) {
  const std::size_t begin = out.size();
  out.resize(begin + bits.size() * width);
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const std::uint64_t change = bits[i] ^ before;
    before = bits[i];
    for (std::size_t byte = 0; byte < width; ++byte)
      out[begin + byte * bits.size() + i] =
          static_cast<char>(change >> (byte_bits * byte) & byte_mask);
  }
}

std::vector<std::uint64_t> take_planes(std::string_view& in, std::size_t count, std::size_t width) {
  if (in.size() / width < count) fail();
  std::vector<std::uint64_t> bits(count);
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t change = 0;
    for (std::size_t byte = 0; byte < width; ++byte)
      change |= static_cast<std::uint64_t>(static_cast<unsigned char>(in[byte * count + i]))
                << (byte_bits * byte);
    bits[i] = before ^= change;
  }
  in.remove_prefix(count * width);
  return bits;
}

void append_count(std::string& out, std::uint32_t count) {
  const std::uint64_t bits = count;
  append_planes(out, {&bits, 1}, sizeof count);
}

std::uint32_t take_count(std::string_view& in) {
  return static_cast<std::uint32_t>(take_planes(in, 1, sizeof(std::uint32_t)).front());
}

}  // namespace sonde
