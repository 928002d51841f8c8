// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/sonde.hpp"

namespace sonde::python {

/// The value that a word stands for. Throws std::invalid_argument, which names those that are
/// known.
template <class Value>
Value chosen(const std::string& what, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& known) {
  std::string words;
  for (const auto& [name, value] : known) {
    if (name == word) return value;
    words += (words.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(what + " is \"" + word + "\"; it is one of " + words);
}
inline Method method_of(const std::string& word) {
  return chosen<Method>("method", word,
                        {{name_of(Method::pdg), Method::pdg}, {name_of(Method::pdt), Method::pdt}});
}
inline Status status_of(const std::string& word) {
  return chosen<Status>("status", word,
                        {{name_of(Status::separated), Status::separated},
                         {name_of(Status::penetrating), Status::penetrating},
                         {name_of(Status::failed), Status::failed}});
}
inline Budget budget_of(int steps, double microseconds) {
  if (steps < 0) throw std::invalid_argument("budget_steps must be 0 (none) or more");
  if (!(microseconds >= 0)) throw std::invalid_argument("budget_us must be 0 (none) or more");
  return {.steps = steps, .microseconds = microseconds};
}

}  // namespace sonde::python
