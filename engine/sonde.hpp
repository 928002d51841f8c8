// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Sonde as a library: how deep two polygon soups are in each other, the nearest pose at which they
/// do not touch, and the force and torque of that separation. This header is all that a program
/// includes. It needs Eigen and nothing else. resources/docs/use/library.md shows how to use it.
///
/// Frames are in the names: X_FM is the pose of the probe's mesh frame M in the fixed body's mesh
/// frame F, x_F = X_FM * x_M. A mesh frame is the frame of the mesh file, in metres. O is the given
/// pose (the device pose), Q the separated pose. Lengths are metres, angles radians, forces
/// newtons, torques newton metres, times seconds.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "engine/base/error.hpp"                              // InputError, Cancelled, Progress
#include "engine/base/phase_times.hpp"                        // Phase, PhaseTimes
#include "engine/base/sentences.hpp"                          // Sentences
#include "engine/body/fingerprint.hpp"                        // fingerprint
#include "engine/calibration/knob.hpp"                        // Knob, Claim
#include "engine/geometry/face_offset.hpp"                    // FaceOffset
#include "engine/geometry/mass.hpp"                           // MassProperties
#include "engine/geometry/model.hpp"                          // Model, Repair
#include "engine/geometry/pose.hpp"                           // Vec3, Mat3, Quat, Pose
#include "engine/haptics/coupling/coupling.hpp"               // Coupling, Wrench
#include "engine/mending/repairs.hpp"                         // Repairs
#include "engine/penetration/contact/separation.hpp"          // Method, Status, Budget, Separation
#include "engine/penetration/restricted/separate_within.hpp"  // separate_along, _about, _in_plane
#include "engine/penetration/search/pair.hpp"                 // Pair
#include "engine/penetration/search/pair_file.hpp"            // write_pair, read_pair
#include "engine/penetration/search/pose_seed.hpp"            // seed_of_pose
#include "engine/penetration/search/static_options.hpp"       // StaticOptions
#include "engine/penetration/sensitivity/principal_stiffness.hpp"  // PrincipalStiffnesses
#include "engine/penetration/sensitivity/wrench_derivative.hpp"    // WrenchDerivative
#include "engine/queries/body_queries.hpp"  // inside, nearest_point, ray, part_at
#include "engine/queries/pair_queries.hpp"  // touch, distance, sweep
#include "engine/queries/pose_matrix.hpp"   // pose_of, matrix_of, isometry_of

namespace sonde {

/// A rigid body made from a mesh. It is immutable, and any number of pairs and threads may share
/// it. facts() describes it.
struct Body;

/// Reads a body from an OFF, OBJ, PLY, STL, GLB, glTF, 3MF or DAE file, text or binary. The
/// extension tells the format. Coordinates are multiplied by `scale`, the file's unit in metres.
/// The last four formats state their unit: their coordinates are converted to metres by it first.
/// @pre `scale` is positive and finite.
/// @throws InputError, naming the file and, where there is one, the line or byte, where the file is
/// missing, empty, truncated or no mesh, an index is out of range, a coordinate is not finite or
/// beyond 1e30 m, no triangle has an area, `model` is solid and the mesh is open or has no volume,
/// or `scale` violates its precondition.
/// @throws Cancelled where `progress` returns false.
std::shared_ptr<const Body> read_body(const std::filesystem::path& file,
                                      Model model = Model::automatic, double scale = 1,
                                      const Progress& progress = {},
                                      Repair repair = Repair::automatic);

/// Makes a body from triangles: `vertices` in metres in its mesh frame, and three indices into them
/// for each triangle, counter-clockwise seen from outside. (A closed mesh that is inside out is
/// turned.) The triangles may meet in any way, or not at all. `name` is used in messages.
/// @throws InputError, naming `name` and the triangle or vertex, where there are no triangles, an
/// index is out of range, a coordinate of any vertex is not finite or one in use is beyond 1e30 m,
/// no triangle has an area, or `model` is solid and the mesh bounds no inside.
/// @throws Cancelled where `progress` returns false.
std::shared_ptr<const Body> make_body(std::span<const Vec3> vertices,
                                      std::span<const std::array<std::uint32_t, 3>> triangles,
                                      Model model = Model::automatic,
                                      const std::string& name = "body",
                                      Repair repair = Repair::automatic,
                                      const Progress& progress = {});

/// A body with each face moved by `by` (m) along its normal: inwards where negative, an allowance,
/// with which a peg as large as its hole fits; outwards where positive, a safety. Planes move by
/// exactly that, and corners to where planes meet; where a corner has no such point, none of its
/// faces moves by less than asked, as far as that can be (facts() counts the corners where it
/// cannot). The mass properties stay those of the given body, except R, so that depths can be
/// compared. Offsets add up. Triangles smaller than the offset may be removed.
/// @throws InputError, naming the body, where it is a surface, `by` is not finite or leads beyond
/// 1e30 m, or the body is thinner somewhere than twice as much as its faces go inwards, with the
/// thinnest place found.
/// @throws Cancelled where `progress` returns false.
std::shared_ptr<const Body> offset_body(const Body& body, double by, const Progress& progress = {});

/// The same body with other mass properties, by which the object norm measures its motions: those
/// of another density (facts() gives the body's own), or a point and moments that weigh turns
/// against displacements: four times the inertia doubles the norm of a turn. `radius` is computed.
/// Forces and torques are about `mass.com`. The result needs as much memory as the body.
/// (The moments need not be those of any mass.)
/// @throws InputError, naming the body, where the measure is not positive, a moment is negative or
/// all are 0, a number is not finite, the centre of mass is over 1000 radii away from the body's,
/// or the axes R_MP are no rotation (to 1e-9).
std::shared_ptr<const Body> with_mass(const Body& body, const MassProperties& mass);

/// Facts about a body.
struct BodyFacts {
  std::string name;            ///< its file, or the name it was given
  std::size_t triangles = 0;   ///< triangles that have an area
  std::size_t degenerate = 0;  ///< triangles set aside because they have no area
  bool solid = false;          ///< its interior counts, not only its triangles
  std::string why;             ///< why it is a solid or a surface: "closed: the inside counts", ...
  /// By what its mass is, where some of its parts are closed and others open ("by area: 97 % of the
  /// area belongs to open parts"); else empty. It is by area where the open ones have more than 1
  /// %.
  std::string mass_why;
  bool turned = false;  ///< the mesh was inside out
  Repairs repairs;      ///< what was done so that it has an inside, counted
  Sentences mended;     ///< the same in words, a sentence each
  Sentences remarks;    ///< what is odd about the file and was read all the same
  /// At density 1, in the mesh frame. The object norm uses it, and torques are about its centre of
  /// mass.
  MassProperties mass;
  /// How far its faces are from those of its mesh (offset_body).
  FaceOffset offset;
};
/// What was found out about a body when it was made.
BodyFacts facts(const Body& body);

/// The mesh of a body as it counts, with what was mended: vertices in its mesh frame, m, and three
/// indices into them for each triangle. They are the body's and live as long as it does.
std::span<const Vec3> vertices(const Body& body);
std::span<const std::array<std::uint32_t, 3>> triangles(const Body& body);  ///< As above.

// Pair (penetration/search/pair.hpp) holds the probe and the fixed body, and what is computed once
// for both.

/// The penetration depth of the probe at X_FM, by a global search: the least √σ found from X_FM to
/// a pose at which the two bodies do not touch. With Method::pdt the search is among the poses that
/// do not turn the probe. The returned pose is verified free with exact predicates, so the depth is
/// an upper bound of the true depth; `lower_bound` is a lower bound. X_FM.q need not have length 1.
///
/// Never throws on geometry: a pose that is not finite, whose quaternion has no length, or that is
/// too far away to compute with, has Status::failed and a reason. The same pair, pose, seed and
/// counted budget give the same bits, on one thread or two. Any number of threads may call it on
/// one pair at once. Allocates.
///
/// `progress` is called on the calling thread between starts, which take milliseconds. Its argument
/// is the share of the permitted starts that is done; most searches end long before 1.
/// @throws InputError, naming the option, where one is outside its range.
/// @throws Cancelled where `progress` returns false.
/// @throws std::bad_alloc.
Separation separate(const Pair& pair, const Pose& X_FM, const StaticOptions& options = {},
                    const Progress& progress = {});

/// How far apart or how deep in each other the bodies are: one number.
struct SignedDistance {
  /// m: the least distance where the bodies are apart, −depth where they are not; not a number
  /// where the search failed.
  double distance = 0;
  Clearance clearance;    ///< where they are apart: the distance with its points
  Separation separation;  ///< the way out where they are not
};

/// distance() where the bodies are apart, and separate() where they are not, in one call. Takes and
/// promises what these do. Both parts are 0 where the bodies just touch; there, the distance is
/// continuous in the pose.
/// @throws InputError as touch() and separate().
/// @throws Cancelled where `progress` returns false.
SignedDistance signed_distance(const Pair& pair, const Pose& X_FM,
                               const StaticOptions& options = {}, const Progress& progress = {});

/// A separation with the accuracy that it claims.
struct Answer {
  Separation separation;  ///< the answer, as of a search with options
  Claim claim;            ///< the claimed accuracy of the depth
  bool late = false;      ///< it took over 1.1 times the time that the knob gave it
};

/// The same search with one knob, a time or an accuracy. Given a time, the accuracy follows; given
/// an accuracy, the time follows, both from the calibration that comes with Sonde. Given neither,
/// it searches until it has converged. Computes no lower bound. Times are wall-clock times, so two
/// runs need not give the same bits.
/// @throws InputError where both are given, the time is negative or not finite, the accuracy is
/// negative, not finite, or at least 1, or `knob.sure` is not between 0 and 1.
/// @throws std::bad_alloc.
Answer separate(const Pair& pair, const Pose& X_FM, const Knob& knob, Method method = Method::pdg,
                std::uint64_t seed = 1);

/// Follows a moving probe and keeps its separated pose. Each separated pose is reached from the one
/// before along a path swept free, on which √σ to the new device pose decreases; it may rise
/// on the way, to at most a quarter of the allowed clearance above its value at the start of the
/// motion, where the probe regains its gaps or takes many steps at once. So the probe never pops
/// through, and the pose may be further away than the nearest one, which separate() finds.
/// Only one thread at a time may use a follower.
class Follower {
 public:
  /// A follower of this pair, which it shares, not started yet. Allocates.
  /// @throws std::bad_alloc.
  explicit Follower(const Pair& pair, Method method = Method::pdg);
  ~Follower();
  Follower(Follower&&) noexcept;  ///< A moved-from follower may only be assigned to or destroyed.
  Follower& operator=(Follower&&) noexcept;  ///< As the move above.
  /// A second follower that goes on from the same state, to the same bits, for a simulator that
  /// rolls back. Takes 1 to 15 ms, since lists of near pairs are copied, and allocates.
  /// @throws std::bad_alloc.
  Follower(const Follower&);
  Follower& operator=(const Follower&);  ///< As the copy above.

  /// Starts at X_FM. If the probe is free there, that is the separated pose. Otherwise a static
  /// search finds one, which may take seconds, and the result is `jumped`. The method and the wish
  /// for a bound in the options have no effect. After a failure the follower has not started.
  /// Allocates.
  /// @throws InputError as separate(); then it is as before.
  /// @throws Cancelled where `progress` returns false (as of separate()); then it is as before.
  /// @throws std::bad_alloc.
  const Separation& start(const Pose& X_FM, const StaticOptions& options = {},
                          const Progress& progress = {});

  /// Follows to the next device pose. Fails before a start, at a pose that is not finite or is
  /// further away than 1e9 times the bodies' size, and with a budget that is not valid. A failure
  /// changes nothing: the next call continues from the pose before. Neither allocates, locks, logs
  /// nor throws. Without a budget it continues until it has converged.
  const Separation& follow(const Pose& X_FM, const Budget& budget = {}) noexcept;

  /// From now on, says where the time of a result went (Separation::phases), or not.
  void time_phases(bool on) noexcept;

  /// The newest result; Status::failed before the first.
  const Separation& last() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Force and torque of a separation, on the hand, in the fixed frame, without damping. The torque
/// is about the probe's centre of mass at the device pose. Both are within the coupling's limits,
/// and zero out of contact and where the separation failed.
/// @pre `now` is a result of this pair, the coupling's gains are finite and its limits not
/// negative. (A wrench that is not finite does not reach the hand: the result is zero, and
/// `saturated`.)
Wrench wrench(const Pair& pair, const Separation& now, const Coupling& coupling) noexcept;

/// The same with the damping of the classic and of the damped mode, from the separation `before`,
/// `dt` seconds ago. (That of the damped mode is of separations that may turn.) There is none where
/// `before` failed, `now` jumped (in the damped mode: fell), or dt is not positive and finite.
/// @pre As above, for both separations.
Wrench wrench(const Pair& pair, const Separation& now, const Separation& before, double dt,
              const Coupling& coupling) noexcept;

// separate_along, separate_about and separate_in_plane
// (penetration/restricted/separate_within.hpp) give the depth among fewer motions.

// wrench_derivative (penetration/sensitivity/wrench_derivative.hpp) says how depth and wrench
// change with the pose: the stiffness that the hand feels. principal_stiffnesses
// (penetration/sensitivity/principal_stiffness.hpp) gives its directions.

// Where members lie is the same for every program, whatever flags it is compiled with: none of
// these types is aligned by what the processor of the program has. A program for which one of these
// fails would read other members than the library wrote.
static_assert(sizeof(void*) != 8 || (sizeof(Pose) == 56 && alignof(Pose) == 8));
static_assert(sizeof(void*) != 8 || (sizeof(Contact) == 88 && sizeof(ContactCluster) == 112));
static_assert(sizeof(void*) != 8 || (sizeof(Separation) == 1976 && alignof(Separation) == 8));
static_assert(offsetof(Pose, q) == 0 && offsetof(Pose, p) == 32);
static_assert(sizeof(void*) != 8 ||
              (offsetof(Separation, device) == 16 && offsetof(Separation, separated) == 72 &&
               offsetof(Separation, depth) == 136 && offsetof(Separation, contacts) == 160 &&
               offsetof(Separation, clusters) == 872 && offsetof(Separation, residual) == 1776 &&
               offsetof(Separation, released) == 1800 && offsetof(Separation, far_out) == 1808 &&
               offsetof(Separation, lower_bound) == 1816 && offsetof(Separation, pdt) == 1832 &&
               offsetof(Separation, clearance) == 1848 && offsetof(Separation, phases) == 1920));
static_assert(sizeof(void*) != 8 ||
              (sizeof(Clearance) == 64 && offsetof(Clearance, overlapping) == 56));
static_assert(sizeof(void*) != 8 || (sizeof(SweptPath) == 160 && offsetof(SweptPath, X_FM) == 16 &&
                                     offsetof(SweptPath, contact) == 72));
static_assert(sizeof(void*) != 8 ||
              (sizeof(SignedDistance) == 2048 && offsetof(SignedDistance, clearance) == 8 &&
               offsetof(SignedDistance, separation) == 72));
static_assert(sizeof(SurfacePoint) == 56 && offsetof(SurfacePoint, distance) == 48);
static_assert(sizeof(void*) != 8 ||
              (sizeof(StaticOptions) == 80 && offsetof(StaticOptions, seed) == 32 &&
               offsetof(StaticOptions, sure) == 48 &&
               offsetof(StaticOptions, want_clearance) == 72));
static_assert(sizeof(void*) != 8 ||
              (sizeof(MassProperties) == 144 && alignof(MassProperties) == 8));
static_assert(sizeof(Budget) == 24 && sizeof(Knob) == 24 && sizeof(Claim) == 16);
static_assert(sizeof(Coupling) == 64 && sizeof(Wrench) == 56);
static_assert(sizeof(void*) != 8 || (sizeof(Answer) == 2000 && offsetof(Answer, claim) == 1976));

}  // namespace sonde
