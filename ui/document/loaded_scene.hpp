// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/recording/recording_header.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"
#include "engine/settings/device_profile.hpp"

namespace sonde::ui {

/// The camera that a scene asks for, in the fixed body's mesh frame, metres.
struct CameraPlace {
  Vec3 position;
  Vec3 target;
  Vec3 up;
};

/// The input of a session: two bodies in place, and their settings. A worker thread makes it, so
/// nothing here touches a widget.
struct LoadedScene {
  Pair pair;
  Scene scene = {};               ///< everything below, as a file would hold it
  std::optional<Pose> here = {};  ///< X_FM, the probe's first pose; none: the start pose
  std::string name = {};
  std::filesystem::path probe_file = {}, fixed_file = {};  ///< the meshes they are made of
  MeshMarks marks = {};                                    ///< those files when they were read
  Pose start = {};  ///< X_FM, the probe's mesh frame in the fixed body's
  Coupling coupling = {};
  ServoSettings servo = {};
  std::vector<TimedPose> trajectory = {};    ///< empty where the scene has none
  std::optional<DeviceProfile> device = {};  ///< the device that the scene simulates
  std::optional<DeviceSettings> device_settings =
      {};                                  ///< the scene's, before those kept for a device
  std::optional<CameraPlace> camera = {};  ///< the scene's `view`; none: the window chooses
  /// Each of the fixed body's parts, felt or not, in the scene's order; empty where it is one mesh.
  std::vector<BodyPart> parts = {};
};

/// Reads a scene, its meshes, its trajectory and the profile of its device. Throws InputError or
/// Cancelled.
LoadedScene open_scene(const std::filesystem::path& file, const Progress& progress = {});
/// The same from a scene in memory.
LoadedScene open_scene(const Scene& scene, const Progress& progress = {});
/// The same from bodies in memory: reads nothing but the device's profile.
LoadedScene open_scene(const Scene& scene, const Pair& pair, std::vector<TimedPose> trajectory,
                       const MeshMarks& marks, std::vector<BodyPart> parts = {});

/// The fixed body of a scene, and its parts where it has any.
struct FixedBody {
  std::shared_ptr<const Body> body;
  std::vector<BodyPart> parts;
};
/// Loads it; parts that are as in `before` are taken from `known`, its parts. Where the scene asks
/// for components, it lists them afterwards. Throws as load.
FixedBody load_fixed(Scene& scene, const Scene& before, const std::vector<BodyPart>& known,
                     const Progress& progress = {});

/// The axis of a mesh file that points up.
enum class UpAxis { x, y, z };

/// The facts about a body that its mesh file does not state, and the user does.
struct BodySetup {
  double unit = 1;  ///< metres per unit of the file; 1 where the file states it
  double scale = 1;
  UpAxis up = UpAxis::z;
  Model model = Model::automatic;
  Repair repair = Repair::automatic;
  double offset = 0;  ///< of the probe: m, by which it is taken larger, less than zero smaller
};
struct PairSetup {
  BodySetup probe, fixed;
};

/// Two meshes as their files hold them, before the user has set their units.
struct MeshPair {
  std::filesystem::path probe_file;
  std::filesystem::path fixed_file;
  PolygonSoup probe;
  PolygonSoup fixed;
  Vec3 probe_size = Vec3::Zero();  ///< sides of the bounding box, in file units
  Vec3 fixed_size = Vec3::Zero();
  MeshMarks marks;
  Topology probe_edges, fixed_edges;  ///< edges that keep the inside from counting
};
MeshPair read_pair(const std::filesystem::path& probe, const std::filesystem::path& fixed,
                   const Progress& progress = {});

/// The probable unit of two meshes, by their larger side: "mm" from 20 up, "cm" from 2, else "m".
/// Objects that a hand explores are centimetres to a metre across.
const char* guess_unit(const MeshPair& pair);

/// The probable unit for both, and everything else as in the files.
PairSetup guess_setup(const MeshPair& pair);
/// One unit for both, but where a file states its own: that is in metres already.
PairSetup same_unit(const MeshPair& pair, double metres);
/// The scale that makes the probe as large as the fixed body, by their larger sides.
double same_size_scale(const MeshPair& pair, const PairSetup& setup);

/// The scene of two meshes, with no pose for the probe. Its unit is the fixed body's; the ratio of
/// the probe's unit goes into its scale, and the up axes into both poses.
Scene scene_of(const MeshPair& pair, const PairSetup& setup);
/// The user's answers that correspond to a scene, as first values of the dialog.
PairSetup setup_of(const Scene& scene);
/// The scene with the user's new answers; poses keep their place relative to the size.
Scene with_setup(const Scene& scene, const PairSetup& old, const PairSetup& now);

/// Builds both bodies; the probe starts just outside the fixed body, on the side of the default
/// camera. Gains: the force limit is reached at 2 % of the probe's radius.
LoadedScene build_pair(MeshPair pair, const PairSetup& setup, const Progress& progress = {});

/// Gains that suit a probe of this size: |F| reaches its limit at a depth of 2 % of R. On a device
/// they are no stiffer than its driver allows, in translation and in rotation.
Coupling suited_coupling(const MassProperties& probe, const DeviceProfile* device = nullptr);
/// What to say of the gains that are set: where they come from if they are as opened (of the
/// scene's file, or suited), what those were if not, and whether the device allows less.
std::string origin_of_gains(const Coupling& gains, bool of_file, const MassProperties& probe,
                            const std::optional<DeviceProfile>& device = std::nullopt);

/// A pose beside the fixed body, turned by q_FM, in the given direction from it: a plane with a gap
/// of 5 % of the probe's radius lies between the two.
Pose beside(const Body& probe, const Body& fixed, const Vec3& direction,
            const Quat& q_FM = Quat::Identity());

}  // namespace sonde::ui
