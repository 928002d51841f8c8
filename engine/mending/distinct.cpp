// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/distinct.hpp"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "engine/base/progress.hpp"
#include "engine/geometry/topology.hpp"

namespace sonde {
namespace {

struct Entry {
  Triangle corners;  // ascending
  std::uint32_t triangle;
  bool even;  // orientation
};

Entry entry_of(const Soup& soup, std::size_t i) {
  Triangle t = soup.triangles[i];
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  const bool even = t[1] < t[2];
  if (!even) std::swap(t[1], t[2]);
  return {t, static_cast<std::uint32_t>(i), even};
}

}  // namespace

Distinct find_distinct(const Soup& soup, const Progress& progress) {
  std::vector<Entry> entries(soup.triangles.size());
  for_each_index(entries.size(), part_of(progress, 0, 0.3),
                 [&](std::size_t i) { entries[i] = entry_of(soup, i); });
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return x.corners != y.corners ? x.corners < y.corners : x.triangle < y.triangle;
  });
  const Components components = find_components(soup, part_of(progress, 0.5, 0.7));
  struct Same {
    std::size_t begin, end;
    long net;
  };
  std::vector<Same> all;
  std::vector<long> common(components.count, 0);
  for (std::size_t i = 0, j = 0; i < entries.size(); i = j) {
    long net = 0;
    for (j = i; j < entries.size() && entries[j].corners == entries[i].corners; ++j)
      net += entries[j].even ? 1 : -1;
    all.push_back({i, j, net});
    long& shared = common[components.of[entries[i].triangle]];
    shared = std::gcd(shared, net);
  }
  Distinct out;
  out.by.assign(soup.triangles.size(), Distinct::none);
  out.backs.assign(soup.triangles.size(), false);
  for (const Same& same : all) {
    const std::uint32_t first = entries[same.begin].triangle;
    const long shared = common[components.of[first]];
    long wanted = shared == 0 ? 1 : std::labs(same.net) / shared;
    const bool even = shared == 0 ? entries[same.begin].even : same.net > 0;
    std::uint32_t last = Distinct::none;
    for (std::size_t k = same.begin; k < same.end; ++k) {
      const std::uint32_t i = entries[k].triangle;
      const bool stays = entries[k].even == even && wanted > 0;
      if (stays) last = i, --wanted;
      out.by[i] = stays ? i : last;
      out.repeated += !stays;
      out.backs[i] = shared == 0 && !stays;
    }
    for (std::size_t k = same.begin; k < same.end; ++k)  // those before the first that stays
      if (out.by[entries[k].triangle] == Distinct::none) out.by[entries[k].triangle] = last;
  }
  return out;
}

}  // namespace sonde
