// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sonde {

/// How often a reader came upon one kind of oddity, and where first: a line, or a byte.
struct Tally {
  std::uint64_t count = 0;
  std::uint64_t first = 0;
  void add(std::uint64_t place) {
    if (count++ == 0) first = place;
  }
};

/// Faces of fewer than three corners, which bound nothing and are set aside.
struct ThinFaces {
  Tally tally;
  bool all_of_two = true;
  void add(std::uint64_t place, std::uint64_t corners) {
    tally.add(place);
    all_of_two = all_of_two && corners == 2;
  }
};

/// What a reader says of the oddities in a mesh that it reads all the same: one remark for each
/// kind, and none where there is none of it. `place` is "line" or "byte".
using Remarks = std::vector<std::string>;

/// "line 12: 3 faces of two corners set aside"; `one` and `many` say what, with a number before it.
void remark(Remarks& remarks, const char* place, const Tally& tally, const char* one,
            const char* many);
void remark(Remarks& remarks, const char* place, const ThinFaces& faces);

/// "26 bytes after the last triangle are not read": nothing where there are none.
void remark_on_bytes(Remarks& remarks, std::uint64_t bytes, const char* after_what);

}  // namespace sonde
