// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/quantity.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& name, const char* expected) {
  throw InputError::in(name, in_quotes(text) + " is not " + expected);
}

}  // namespace

double time_in(std::string_view text, const std::string& name) {
  // Longer endings first: "s" ends all of them.
  constexpr std::array<std::pair<std::string_view, double>, 4> units{
      {{"us", 1e-6}, {"µs", 1e-6}, {"ms", 1e-3}, {"s", 1}}};
  std::string_view digits = text;
  double unit = 1;
  for (const auto& [ending, size] : units)
    if (text.ends_with(ending)) {
      digits.remove_suffix(ending.size());
      unit = size;
      break;
    }
  const std::optional<double> value = parse_number(digits);
  if (!value || !std::isfinite(*value) || !(*value * unit > 0))
    refuse(text, name, "a time above zero, as in 1ms, 800us or 0.02s");
  return *value * unit;
}

double share_in(std::string_view text, const std::string& name) {
  const bool per_cent = text.ends_with('%');
  const auto value = parse_number(per_cent ? text.substr(0, text.size() - 1) : text);
  const double share = value.value_or(0) * (per_cent ? 0.01 : 1);
  if (!(share > 0 && share < 1))
    refuse(text, name, "a share above 0 and below 100%, as in 1% or 0.01");
  return share;
}

}  // namespace sonde
