// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/geometry/repeated.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "engine/base/progress.hpp"

namespace sonde {
namespace {

struct Entry {
  Triangle corners;  ///< ascending
  std::uint32_t triangle;
  bool even;  ///< orientation
};

Entry entry(const Soup& soup, std::size_t i) {
  Triangle t = soup.triangles[i];
  const auto low = std::min_element(t.begin(), t.end());
  std::rotate(t.begin(), low, t.end());
  const bool even = t[1] < t[2];
  if (!even) std::swap(t[1], t[2]);
  return {t, static_cast<std::uint32_t>(i), even};
}

/// How much more often they turn the one way than the other.
long turns(std::span<const Entry> same) {
  return std::accumulate(same.begin(), same.end(), 0L,
                         [](long sum, const Entry& e) { return sum + (e.even ? 1 : -1); });
}

}  // namespace

std::vector<bool> repeated_triangles(const Soup& soup, bool solid, const Progress& progress) {
  // Triangles with the same corners lie beside each other when sorted by them.
  std::vector<Entry> entries(soup.triangles.size());
  for_each_index(entries.size(), progress, [&](std::size_t i) { entries[i] = entry(soup, i); });
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return x.corners != y.corners ? x.corners < y.corners : x.triangle < y.triangle;
  });
  std::vector<std::span<const Entry>> repeated;
  long all_turns = 0;
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    for (j = i; j < entries.size() && entries[j].corners == entries[i].corners;) ++j;
    const std::span<const Entry> same(entries.data() + i, j - i);
    all_turns = std::gcd(all_turns, turns(same));
    if (same.size() > 1) repeated.push_back(same);
  }
  std::vector<bool> out(soup.triangles.size(), false);
  for (const std::span<const Entry> same : repeated) {
    const long left = all_turns != 0 ? turns(same) / all_turns : 0;
    long even = left > 0 ? left : left == 0, odd = left < 0 ? -left : left == 0;
    if (!solid) even = odd = 1;
    for (const Entry& e : same) {
      long& wanted = e.even ? even : odd;
      out[e.triangle] = --wanted < 0;
    }
  }
  return out;
}

}  // namespace sonde
