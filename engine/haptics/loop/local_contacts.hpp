// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "engine/geometry/mass.hpp"
#include "engine/haptics/loop/loop_tuning.hpp"
#include "engine/penetration/contact/separation.hpp"

namespace sonde {

/// A contact as a constraint on the pose of the probe: the probe's point a stays on the outer side
/// of the plane through b. The plane is fixed in the world.
struct LocalContact {
  Vec3 on_probe = Vec3::Zero();  ///< a, in the probe's mesh frame, m
  Vec3 on_fixed = Vec3::Zero();  ///< b, in the fixed body's mesh frame, m
  Vec3 normal = Vec3::UnitZ();   ///< n, unit, from B to A, in the fixed body's mesh frame
  double least_gap = 0;          ///< lower limit of n·(a − b), m
};

/// The geometry's result for one device pose, with the rows near its separated pose that the servo
/// needs until the next result: plain data, copied through a triple buffer.
struct LocalContacts {
  static constexpr int capacity = loop_tuning.most_rows;
  std::array<LocalContact, capacity> rows;  ///< those that hold the probe first
  int size = 0;
  /// m. As long as no point of the probe is further than this from its position at the separated
  /// pose, the probe can meet only features that have a row here.
  double reach = 0;
  Separation separation;    ///< for the device pose of that tick; failed: there are no rows
  std::uint64_t tick = 0;   ///< the tick of the servo that sampled the pose
  double time = 0;          ///< s, time of that tick on the servo's clock
  std::uint64_t jumps = 0;  ///< number of ticks that jumped so far
  std::uint64_t falls = 0;  ///< those of them that fell (Separation::fell)
  double released = 0;      ///< m²: sum of Separation::released so far
  double refresh_us = 0;    ///< time that the geometry took
};

/// The answer of the rows at another device pose.
struct LocalAnswer {
  Separation separation;  ///< of the new device pose; iterations and converged are the geometry's
  /// The half-spaces of the rows have no common point, or the solution is farther from the
  /// geometry's separated pose than the rows are trusted (LoopTuning::trusted). The answer then
  /// goes only as far as that, so the force is that of a probe that lags behind.
  bool held_back = false;
  /// m: length of the part of y that is no combination of the rows' normals (y − Jᵀλ): 0 unless the
  /// probe lags behind their optimum. With translation only, it includes the turn that the geometry
  /// has not followed. If the rows have no common point, or if there are none though the probe is
  /// held, it is that of the geometry's answer.
  double lag = 0;
};

/// The pose nearest to the device pose X_FM that satisfies the rows, in the object norm: a
/// least-distance problem (least_distance.hpp), linearised again at its solution a few times, so
/// that the solution follows a turn exactly. At the device pose of the rows it is the geometry's
/// separated pose, to its residual. The pose is not tested against the bodies. Translation only if
/// the method is pdt. Never allocates.
///
/// Error bound: depths at two device poses differ by at most the object norm δ of the motion
/// between them; this holds for this answer's depth and for the true one. So the two differ by at
/// most 2δ, where δ is the motion of the device since the rows were made, unless the separated pose
/// jumps. While contacts persist the error is of the order of δ²/ρ, with ρ the radius of curvature
/// of the contact.
///
/// Beyond the reach of the rows the contacts are unknown, but most surfaces continue smoothly. So
/// the separated pose may move by a tenth of the probe's radius, or by the reach if that is more,
/// but no farther. This errs on the safe side: a probe that lags takes energy from the hand,
/// whereas one that has passed through a surface would give energy to the hand as soon as the
/// geometry noticed.
LocalAnswer separate_locally(const MassProperties& mass, Method method,
                             const LocalContacts& contacts, const Pose& X_FM) noexcept;

}  // namespace sonde
