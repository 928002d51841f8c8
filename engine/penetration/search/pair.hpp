// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace sonde {

struct Body;
struct Sketches;

/// The two bodies of a search, a probe A that moves and a fixed body B, with what searches know of
/// them both: their sketches (proximity/sketch/sketch.hpp). Immutable; copies share it, and any
/// number of threads may use it at once.
class Pair {
 public:
  /// Makes the sketches, on two threads: 10 to 50 ms on meshes of up to 30 k triangles, 0.2 s on
  /// two of 4 M. So it belongs where the bodies are loaded. Throws std::invalid_argument where a
  /// body is missing.
  Pair(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed);
  // Nothing moves from a pair: there is none without bodies.
  Pair(const Pair&) noexcept = default;
  Pair& operator=(const Pair&) noexcept = default;
  ~Pair() = default;

  const Body& probe() const noexcept { return *probe_; }
  const Body& fixed() const noexcept { return *fixed_; }
  /// None where both bodies are surfaces, or one is too small or too large for them.
  const Sketches& sketches() const noexcept { return *sketches_; }

 private:
  std::shared_ptr<const Body> probe_, fixed_;
  std::shared_ptr<const Sketches> sketches_;
};

}  // namespace sonde
