// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/mass.hpp"
#include "engine/haptics/loop/loop_tuning.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// What a contact requires of any pose of the probe: its point a stays on the outer side of the
/// plane through b, which is fixed in the world.
struct LocalContact {
  Vec3 on_probe = Vec3::Zero();  ///< a, in the probe's mesh frame, m
  Vec3 on_fixed = Vec3::Zero();  ///< b, in the fixed body's mesh frame, m
  Vec3 normal = Vec3::UnitZ();   ///< n, unit, from B to A, in the fixed body's mesh frame
  double least_gap = 0;          ///< n·(a − b) is not to fall below, m
};

/// What the geometry found for one device pose, and what is to be known of the surroundings of the
/// separated pose until it has found the next: plain data, copied through a triple buffer.
struct LocalContacts {
  static constexpr int capacity = loop_tuning.most_rows;
  std::array<LocalContact, capacity> rows;  ///< those that hold the probe first
  int size = 0;
  /// m. Where no point of the probe is farther than this from where it is at the separated pose,
  /// the probe meets nothing that has no row here.
  double reach = 0;
  Separation separation;    ///< of the device pose of that tick; failed: there are no rows
  std::uint64_t tick = 0;   ///< the tick of the servo that took the pose
  double time = 0;          ///< s, when that tick took it, on the servo's clock
  std::uint64_t jumps = 0;  ///< how often the separated pose has jumped so far
  double released = 0;      ///< m²: Separation::released, all of it so far
  double refresh_us = 0;    ///< time the geometry took
};

/// The result of the rows at another device pose.
struct LocalAnswer {
  Separation separation;  ///< of the new device pose; iterations and converged are the geometry's
  /// The rows have no common point, or led farther from the geometry's separated pose than they are
  /// trusted. The answer goes only that far, and the force is that of a probe that lags behind.
  bool held_back = false;
};

/// The pose nearest to the device pose X_FM that satisfies the rows, in the object norm: a
/// least-distance problem (least_distance.hpp), linearised again at its answer a few times, so that
/// the solution follows a turn exactly. At the device pose of the rows it is the geometry's
/// separated pose, to its residual. The pose is not tested against the bodies. Translation only
/// where the method is pdt. Never allocates.
///
/// How wrong it can be: depths at two device poses differ by at most the object norm δ of the
/// motion between them, this one's as well as the true one's. So the two differ by at most 2δ, with
/// δ how far the device has moved since the rows were made, unless the separated pose jumps. While
/// contacts persist the error is of the order of δ²/ρ, with ρ the radius of curvature of the
/// contact.
///
/// What lies beyond the reach of the rows is not known, but most surfaces continue as they are. So
/// the separated pose may go a tenth of the probe's radius, or as far as the reach, and no farther.
/// A probe that lags takes energy from the hand; one that went through would give energy once the
/// geometry noticed.
LocalAnswer separate_locally(const MassProperties& mass, Method method,
                             const LocalContacts& contacts, const Pose& X_FM) noexcept;

}  // namespace sonde
