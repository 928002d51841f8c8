// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sonde as a library: how deep two polygon soups are in each other, the nearest pose at which they
/// are apart, and the force and torque that go with it. This header is all that a program needs; it
/// needs Eigen and nothing else. resources/docs/use/library.md shows it in use.
///
/// Frames are in the names: X_FM is the pose of the probe's mesh frame M in the fixed body's mesh
/// frame F, x_F = X_FM * x_M. A mesh frame is that of the mesh's file, in metres. O is the pose
/// that is asked about (the device's), Q the separated one. Lengths are metres, angles radians,
/// forces newtons, torques newton metres, times seconds.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "engine/base/error.hpp"                        // InputError, Cancelled, Progress
#include "engine/calibration/knob.hpp"                  // Knob, Claim
#include "engine/geometry/mass.hpp"                     // MassProperties
#include "engine/geometry/model.hpp"                    // Model
#include "engine/geometry/pose.hpp"                     // Vec3, Mat3, Quat, Pose
#include "engine/haptics/coupling/coupling.hpp"         // Coupling, Wrench
#include "engine/penetration/contact/separation.hpp"    // Method, Status, Budget, Separation
#include "engine/penetration/search/pair.hpp"           // Pair
#include "engine/penetration/search/static_search.hpp"  // StaticOptions

namespace sonde {

/// A rigid body made of a mesh: immutable, to be shared by as many pairs and threads as wanted.
/// What there is to know of one is in its facts.
struct Body;

/// Reads a body from an OFF, OBJ, PLY (text or binary) or STL (text or binary) file, told apart by
/// extension. Coordinates are multiplied by `scale`, the file's unit in metres.
/// @pre `scale` is positive and finite.
/// @throws InputError, naming the file and where there is one the line or byte, where the file is
/// missing, empty, truncated or no mesh, an index is out of range, a coordinate is not finite or
/// beyond 1e30 m, no triangle has an area, `model` is solid and the mesh is open or has no volume,
/// or `scale` is not as asked for.
/// @throws Cancelled where `progress` returns false.
std::shared_ptr<const Body> read_body(const std::filesystem::path& file,
                                      Model model = Model::automatic, double scale = 1,
                                      const Progress& progress = {});

/// Makes a body of triangles: `vertices` in metres in its mesh frame, three indices into them for
/// each triangle, counter-clockwise seen from outside (a closed mesh that is inside out is turned).
/// Nothing is assumed of how triangles meet. `name` is for what is said of it.
/// @throws InputError, naming `name` and the triangle or vertex, where there are no triangles, an
/// index is out of range, a coordinate of any vertex is not finite or one in use is beyond 1e30 m,
/// no triangle has an area, or `model` is solid and the mesh is open or has no volume.
std::shared_ptr<const Body> make_body(std::span<const Vec3> vertices,
                                      std::span<const std::array<std::uint32_t, 3>> triangles,
                                      Model model = Model::automatic,
                                      const std::string& name = "body");

/// What is known of a body.
struct BodyFacts {
  std::string name;            ///< its file, or the name it was given
  std::size_t triangles = 0;   ///< that have an area
  std::size_t degenerate = 0;  ///< triangles set aside for having none
  bool solid = false;          ///< its interior counts, not its triangles alone
  std::string why;             ///< it is a solid or a surface: "closed: the inside counts", ...
  bool turned = false;         ///< the mesh was inside out
  /// At density 1, in the mesh frame: the object norm is made of it, and torques are about its
  /// centre of mass.
  MassProperties mass;
};
BodyFacts facts(const Body& body);

// Pair (penetration/search/pair.hpp) is the probe and the fixed body, with what is made once for
// both.

/// The penetration depth of the probe at X_FM, searched globally: the least √σ from X_FM to any
/// pose at which the two are apart that is found; with Method::pdt, among those that do not turn
/// the probe. The pose returned is verified free with exact predicates, so the depth is an upper
/// bound of the true one; `lower_bound` is one from below. X_FM.q need not have length 1.
///
/// Never throws on geometry: a pose that is not finite, or too far away to compute with, has
/// Status::failed and a reason. The same pair, pose, seed and counted budget give the same bits, on
/// one thread or two. May be called on one pair from any number of threads at once. Allocates.
/// @throws std::bad_alloc.
Separation separate(const Pair& pair, const Pose& X_FM, const StaticOptions& options = {});

/// An answer to the knob.
struct Answer {
  Separation separation;
  Claim claim;  ///< how near to the true depth it claims to be
};

/// The same with one knob: a time, and the accuracy follows, or an accuracy, and the time follows,
/// by what was measured on the pairs that the calibration which ships is made of. Without a bound.
/// Neither: until it has converged. Times are those of the wall's clock, so no two runs need give
/// the same bits.
/// @throws InputError where both are given, the time is negative or not finite, or the accuracy is
/// negative, not finite, or 1 and more. @throws std::bad_alloc.
Answer separate(const Pair& pair, const Pose& X_FM, const Knob& knob, Method method = Method::pdg,
                std::uint64_t seed = 1);

/// The separated pose of a probe that moves, pose by pose: each is reached from the one before
/// along a path swept free, on which √σ to the new device pose never rises. So it never pops
/// through, and may be further away than the nearest pose that separate() finds. To be used by one
/// thread at a time.
class Follower {
 public:
  explicit Follower(const Pair& pair, Method method = Method::pdg);
  ~Follower();
  Follower(Follower&&) noexcept;  ///< What was moved from may only be assigned to or destroyed.
  Follower& operator=(Follower&&) noexcept;

  /// Starts at X_FM: free there, or from what a static search finds, which may take seconds; the
  /// result is `jumped` then. Of the options, the method and the bound asked for do not count.
  /// Where it failed it has not started. Allocates.
  /// @throws std::bad_alloc.
  const Separation& start(const Pose& X_FM, const StaticOptions& options = {});

  /// The next device pose. Fails before a start, and at a pose that is not finite or is further
  /// away than 1e9 times the bodies' size: then nothing has changed, and the next goes on from the
  /// pose before. Neither allocates, locks, logs nor throws. Without a budget it goes on until it
  /// has converged.
  const Separation& follow(const Pose& X_FM, const Budget& budget = {}) noexcept;

  /// The newest result; Status::failed before the first.
  const Separation& last() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Force and torque of a separation, on the hand, in the fixed frame, the torque about the probe's
/// centre of mass at the device pose, within the coupling's limits: zero out of contact and where
/// the separation failed. No damping.
/// @pre `now` is of this pair, the coupling's gains are finite and its limits not negative. (What
/// is not finite does not reach the hand: that wrench is zero, and `saturated`.)
Wrench wrench(const Pair& pair, const Separation& now, const Coupling& coupling) noexcept;

/// The same with the damping of the classic mode, from the separation `before`, `dt` seconds ago.
/// Nothing is damped where `before` failed, `now` jumped, or dt is not positive and finite.
/// @pre As above, of both separations.
Wrench wrench(const Pair& pair, const Separation& now, const Separation& before, double dt,
              const Coupling& coupling) noexcept;

}  // namespace sonde
