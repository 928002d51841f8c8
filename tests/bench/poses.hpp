// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "engine/body/body.hpp"

namespace sonde::bench {

/// Where A is put against B. The gaps are those between triangles; R is the radius of the meshes.
enum class Place {
  far,         ///< 2 R apart
  near_5,      ///< 5 % of R apart
  near_1,      ///< 1 % of R apart
  touching,    ///< 1e-6 of R apart
  shallow,     ///< 1 % of R further on than touching
  deep,        ///< 30 % of R further on than touching
  trajectory,  ///< steps of about 0.2 % of R, sliding round B at a gap of 1 % of R
  trip,        ///< not poses but long motions with a turn
  none,        ///< no pose: building
};
const char* name_of(Place place);

/// How far a pose of this kind is from the one just touching, m.
double from_touching(Place place);

/// A motion of the probe from one pose to another.
struct Trip {
  Pose from, to;
};

struct PoseSet {
  std::map<Place, std::vector<Pose>> poses;
  Pose lead_in;  ///< the step before the first of the trajectory
  std::vector<Trip> trips;
};

struct PoseCounts {
  int poses = 0;  ///< of each kind
  int steps = 0;  ///< of the trajectory
  int trips = 0;
};

/// Poses X_BA of one pair, the same for the same seed. Each comes from moving A straight at B, from
/// a random side and in a random orientation, until the gap is what is asked for. `linked`: A and B
/// are rings, A stays linked with B (so that there are no far poses). Poses of `shallow` and `deep`
/// are kept only where triangles meet.
PoseSet make_poses(const Body& a, const Body& b, bool linked, const PoseCounts& counts,
                   std::uint64_t seed);

}  // namespace sonde::bench
