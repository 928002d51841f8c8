// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/kept_pairs.hpp"

#include <algorithm>

#include "engine/penetration/contact/contact_tuning.hpp"
#include "engine/proximity/queries/triangle_batch.hpp"

namespace sonde {

KeptPairs::KeptPairs(const Body& probe, const Body& fixed)
    : probe_(probe), fixed_(fixed), pairs_(contact_tuning.most_kept) {}

void KeptPairs::keep(const TrianglePair& pair) noexcept {
  const auto begin = pairs_.begin(), end = begin + static_cast<std::ptrdiff_t>(count_);
  const auto found = std::find(begin, end, pair);
  if (found != end)
    std::rotate(found, found + 1, end);
  else if (count_ < pairs_.size())
    pairs_[count_++] = pair;
  else
    std::rotate(begin, begin + 1, end), pairs_.back() = pair;
}

std::size_t KeptPairs::add_to(std::span<NearPair> pairs, std::size_t count, const Transform& X,
                              double reach) noexcept {
  TriangleBatch batch(probe_, fixed_, X);
  std::size_t left = 0;
  const auto look = [&] {
    batch.flush(reach, [&](const TriangleBatch::Pair& pair, int k, const ClosestPoints8& points) {
      if (!(points.distance[k] > 0) || points.distance[k] > reach) return;
      pairs_[left++] = {pair.i, pair.j};
      const NearPair near = near_pair(pair, k, points);
      const bool is_known = std::ranges::any_of(pairs.first(count), [&](const NearPair& p) {
        return p.triangle_a == near.triangle_a && p.triangle_b == near.triangle_b;
      });
      if (!is_known) pairs[count++] = near;
    });
  };
  for (std::size_t i = 0; i < count_; ++i) {
    batch.add(pairs_[i].a, pairs_[i].b);
    if (batch.full()) look();
  }
  look();
  count_ = left;
  return count;
}

}  // namespace sonde
