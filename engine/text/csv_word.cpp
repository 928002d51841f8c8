// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/csv_word.hpp"

namespace sonde {

std::string csv_word(const std::string& word) {
  if (word.find_first_of(",\"\r\n") == std::string::npos) return word;
  std::string out = "\"";
  for (const char c : word) out.append(c == '"' ? 2 : 1, c);
  return out + "\"";
}

}  // namespace sonde
