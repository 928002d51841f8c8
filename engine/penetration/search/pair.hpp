// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "engine/base/error.hpp"

namespace sonde {

struct Body;
struct Sketches;

/// The two bodies of a search, a moving probe A and a fixed body B, with their sketches, which
/// guide searches (proximity/sketch/sketch.hpp). Immutable. Copies share the bodies and sketches,
/// and any number of threads may use a pair at once.
class Pair {
 public:
  /// Makes the sketches, on two threads: 10 to 50 ms on meshes of up to 30 k triangles, 0.2 s on
  /// two of 4 M. So make a pair where you load the bodies.
  /// @throws InputError if a body is missing.
  /// @throws Cancelled if `progress` returns false.
  Pair(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed,
       const Progress& progress = {});
  // There is no move: a moved-from pair would have no bodies.
  Pair(const Pair&) noexcept = default;             ///< Shares bodies and sketches.
  Pair& operator=(const Pair&) noexcept = default;  ///< Shares bodies and sketches.
  ~Pair() = default;

  /// A, the moving body.
  const Body& probe() const noexcept { return *probe_; }
  /// B, the fixed body.
  const Body& fixed() const noexcept { return *fixed_; }
  /// Empty if both bodies are surfaces, or if one is too small or too large for a sketch.
  const Sketches& sketches() const noexcept { return *sketches_; }

  /// The same bodies with exchanged roles: the fixed body as the probe. Shares bodies and sketches.
  Pair exchanged() const;

 private:
  friend Pair read_pair(const std::filesystem::path& file, std::shared_ptr<const Body> probe,
                        std::shared_ptr<const Body> fixed);
  Pair(std::shared_ptr<const Body> probe, std::shared_ptr<const Body> fixed,
       std::shared_ptr<const Sketches> sketches) noexcept;

  std::shared_ptr<const Body> probe_, fixed_;
  std::shared_ptr<const Sketches> sketches_;
};

}  // namespace sonde
