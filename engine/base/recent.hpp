// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sonde {

/// A cache for numbers that recur within a short time: each slot holds its newest entry. Never
/// allocates.
template <class Value, std::size_t places = 64>
class Recent {
 public:
  Recent() { number_.fill(none); }

  /// The result of make(number), which must be the same every time. The reference is valid until
  /// the next call. The number must not be 2³² − 1.
  template <class Make>
  const Value& at(std::uint32_t number, const Make& make) {
    const std::size_t place = number % places;
    if (number_[place] != number) value_[place] = make(number), number_[place] = number;
    return value_[place];
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  std::array<std::uint32_t, places> number_;
  std::array<Value, places> value_;
};

}  // namespace sonde
