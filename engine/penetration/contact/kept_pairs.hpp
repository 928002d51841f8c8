// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/near_pairs.hpp"

namespace sonde {

/// Triangle `a` of surface(probe) and triangle `b` of surface(fixed).
struct TrianglePair {
  std::uint32_t a, b;
  bool operator==(const TrianglePair&) const = default;
};

/// The pairs of triangles that were active in a solution or obstructed a step, in recent gathers.
/// Every gather examines them, however many other pairs are as near (ContactRows). Only the
/// constructor allocates.
class KeptPairs {
 public:
  /// @pre The bodies outlive this object.
  KeptPairs(const Body& probe, const Body& fixed);

  void forget() noexcept { count_ = 0; }
  /// Makes a pair the newest one. If there is no room (ContactTuning::most_kept), forgets the
  /// oldest.
  void keep(const TrianglePair& pair) noexcept;
  /// Appends the kept pairs within `reach` (m) at X to the first `count` pairs of `pairs`, except
  /// those that are among these already, and forgets the kept pairs that are farther apart or that
  /// meet. Returns the number of pairs with the new ones.
  /// @pre There is room for ContactTuning::most_kept more.
  std::size_t add_to(std::span<NearPair> pairs, std::size_t count, const Transform& X,
                     double reach) noexcept;

 private:
  const Body& probe_;
  const Body& fixed_;
  std::vector<TrianglePair> pairs_;  // the newest last
  std::size_t count_ = 0;
};

}  // namespace sonde
