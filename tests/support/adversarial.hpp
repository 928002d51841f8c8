// SPDX-License-Identifier: GPL-3.0-or-later
// Soups and poses that are hard on floating point, by seed. Corners are whole multiples of 2^-30 of
// the size of a soup, which is a power of two: so are sums and differences of them, also where the
// soup lies 2^20 sizes from the origin of its mesh frame, and a pose that turns by quarters places
// them without rounding.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/proximity/sweep/motion.hpp"
#include "tests/support/pairs.hpp"

namespace sonde::test {

enum class Family {
  loose,       ///< triangles of all directions
  needles,     ///< aspect 1e8: one side 2^-27 of the others
  caps,        ///< aspect 1e8: a corner 2^-27 over the opposite side
  bundle,      ///< needles and slim triangles at angles of 1e-3 to 1e-8 with each other
  coplanar,    ///< faces of one plane, overlapping
  hinge,       ///< all on one edge
  fan,         ///< all at one corner
  duplicated,  ///< every face up to four times, turned over and begun at another corner
  sheets,      ///< a stack of parallel sheets, 2^-10 to 2^-28 apart
  all_sizes,   ///< sides from 1 to 2^-22
  mesh,        ///< a closed mesh: shared edges and corners
};
constexpr int families = 11;
const char* name(Family family);

/// Of size 1, within [-1, 1]³.
PolygonSoup adversarial_soup(Family family, int triangles, std::mt19937_64& random);

/// Where a soup stands and how large it is: size 2^±20 (about 1e±6), or 2^20 sizes away.
enum class Place { plain, tiny, huge, far, count };

/// Two soups of a family (the second is now and then of another, or the first one again).
BodyPair adversarial_pair(Family family, Place place, int triangles, std::mt19937_64& random);

/// A pose with what is known of it.
struct HardPose {
  enum class Kind {
    quarter_turn,    ///< exact: nothing rounds
    turned,          ///< any rotation
    touching,        ///< exact, a plane between the two touches both in one place of each: contact
    overlapping,     ///< as that, one to four ulps deeper
    ulps_off,        ///< as that, one to four ulps apart: free
    turned_touching  ///< corner on corner, edge or face but for rounding, at any rotation
  };
  static constexpr int kinds = 6;
  Kind kind;
  Transform X;
};
HardPose hard_pose(HardPose::Kind kind, const BodyPair& pair, std::mt19937_64& random);

/// Largest coordinate there is at X, both bodies together: what rounding is measured in.
double size_at(const BodyPair& pair, const Transform& X);

/// One of the 24 rotations by quarters.
Mat3 quarter_turn(std::mt19937_64& random);

/// Calls check(pair, pose, text) on every family at every place: `pairs` pairs of `triangles` each,
/// with `poses` of every kind.
template <class Check>
void for_adversarial_poses(std::uint64_t seed, int pairs, int triangles, int poses,
                           const Check& check) {
  std::mt19937_64 random(seed);
  for (int f = 0; f < families; ++f)
    for (int place = 0; place < static_cast<int>(Place::count); ++place)
      for (int p = 0; p < pairs; ++p) {
        const BodyPair pair =
            adversarial_pair(static_cast<Family>(f), static_cast<Place>(place), triangles, random);
        for (int i = 0; i < poses * HardPose::kinds; ++i) {
          const HardPose pose =
              hard_pose(static_cast<HardPose::Kind>(i % HardPose::kinds), pair, random);
          check(pair, pose, pair.name + ", pose " + std::to_string(i));
        }
      }
}

}  // namespace sonde::test
