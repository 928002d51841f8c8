// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/nearest.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace sonde {
namespace {

/// With small letters for capital ones of ASCII.
std::string small(std::string_view word) {
  std::string out(word);
  for (char& letter : out)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return out;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  // Three rows of the table of distances between prefixes of a and b: the current one and two
  // before.
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> known) {
  const std::string_view start = word.substr(0, 100);  // a malicious key may be as long as its file
  const std::string folded = small(start);
  // Capitals are no other word: of "MM", "mm" is nearer than "cm". Of two equally near words, the
  // longer: letters are omitted more often than added.
  const auto found = std::ranges::min_element(known, {}, [&](std::string_view candidate) {
    return std::tuple(edit_distance(folded, small(candidate)), edit_distance(start, candidate),
                      ~candidate.size());
  });
  return found == known.end() ? std::string_view{} : *found;
}

}  // namespace sonde
