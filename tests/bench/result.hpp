// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tests/bench/statistics.hpp"

namespace sonde::bench {

/// What one library did in one row.
struct LibraryResult {
  std::string library;
  Calls calls;
  std::size_t compared = 0;  ///< answers compared with Sonde's
  std::size_t excused = 0;   ///< of them, different where its numbers cannot tell
  std::size_t missed = 0;    ///< of them, known to be wrong
  std::optional<double> amount;
};

/// One query on one pair of meshes at the poses of one kind.
struct Result {
  std::string query, pair, poses;
  std::size_t triangles_a = 0, triangles_b = 0;
  bool scale = false;       ///< one of the pairs that grow from 1 k to 1 M triangles
  std::string amount_name;  ///< "rows", "bytes per triangle", or "" where there is none
  std::vector<LibraryResult> libraries;

  const LibraryResult* find(const std::string& library) const {
    for (const LibraryResult& r : libraries)
      if (r.library == library) return &r;
    return nullptr;
  }
};

/// The library that the others are compared with.
constexpr const char* ours = "Sonde";

}  // namespace sonde::bench
