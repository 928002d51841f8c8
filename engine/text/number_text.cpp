// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/number_text.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace sonde {
namespace {

/// The power of ten that is written behind an e; 0 where there is none.
std::int64_t written_exponent(std::string_view digits) {
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  std::int64_t value = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end.ec != std::errc::result_out_of_range) return value;
  constexpr std::int64_t huge = std::numeric_limits<std::int64_t>::max() / 2;
  return digits.front() == '-' ? -huge : huge;
}

}  // namespace

double out_of_range_number(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  if (first == mantissa.npos) return 0;
  const auto power = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  const std::int64_t exponent = e < text.size() ? written_exponent(text.substr(e + 1)) : 0;
  return power + exponent < 0 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace sonde
