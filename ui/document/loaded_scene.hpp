// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"
#include "engine/settings/device_profile.hpp"

namespace sonde::ui {

/// Where a scene wants to be looked at from, in the fixed body's mesh frame, metres.
struct CameraPlace {
  Vec3 position;
  Vec3 target;
  Vec3 up;
};

/// What a session starts from: two bodies in place, and the settings that go with them. Made in a
/// worker thread, so nothing here touches a widget.
struct LoadedScene {
  Pair pair;
  Scene scene = {};               ///< all that follows, as a file would hold it
  std::optional<Pose> here = {};  ///< X_FM, where the probe begins; none: at the start
  std::string name = {};
  std::filesystem::path probe_file = {}, fixed_file = {};  ///< the meshes they are made of
  Pose start = {};  ///< X_FM, the probe's mesh frame in the fixed body's
  Coupling coupling = {};
  ServoSettings servo = {};
  std::vector<TimedPose> trajectory = {};    ///< empty where the scene has none
  std::optional<DeviceProfile> device = {};  ///< what the scene wants simulated
  std::optional<DeviceSettings> device_settings =
      {};                                  ///< the scene's, before those kept for a device
  std::optional<CameraPlace> camera = {};  ///< the scene's `view`; none: the window chooses
};

/// Reads a scene, its meshes, its trajectory and the profile of its device. Throws InputError or
/// Cancelled.
LoadedScene open_scene(const std::filesystem::path& file, const Progress& progress = {});
/// The same of a scene that is in memory.
LoadedScene open_scene(const Scene& scene, const Progress& progress = {});
/// The same of bodies that are in memory too: nothing but the device's profile is read.
LoadedScene open_scene(const Scene& scene, const Pair& pair, std::vector<TimedPose> trajectory);

/// Where a mesh file's up lies.
enum class UpAxis { x, y, z };

/// What a mesh file does not say of a body, and a person does.
struct BodySetup {
  double unit = 1;  ///< metres per unit of the file
  double scale = 1;
  UpAxis up = UpAxis::z;
  Model model = Model::automatic;
};
struct PairSetup {
  BodySetup probe, fixed;
};

/// Two meshes as their files give them, before anybody has said what their unit is.
struct MeshPair {
  std::filesystem::path probe_file;
  std::filesystem::path fixed_file;
  PolygonSoup probe;
  PolygonSoup fixed;
  Vec3 probe_size = Vec3::Zero();  ///< sides of the bounding box, in file units
  Vec3 fixed_size = Vec3::Zero();
  Topology probe_edges, fixed_edges;  ///< what was found that keeps an inside from counting
};
MeshPair read_pair(const std::filesystem::path& probe, const std::filesystem::path& fixed,
                   const Progress& progress = {});

/// The unit two meshes are probably in, by their larger side: "mm" from 20 up, "cm" from 2, else
/// "m". Objects that a hand explores are centimetres to a metre across.
const char* guess_unit(const MeshPair& pair);

/// The likely unit for both, and all else as the files have it.
PairSetup guess_setup(const MeshPair& pair);
PairSetup same_unit(double metres);
/// The scale with which the probe is as large as the fixed body, by their larger sides.
double same_size_scale(const MeshPair& pair, const PairSetup& setup);

/// The scene that two meshes make, with nothing said of the probe's place: its unit is the fixed
/// body's, what the probe's differs goes into its scale, and what is up into both poses.
Scene scene_of(const MeshPair& pair, const PairSetup& setup);
/// What a scene says of its two mesh files, for the question to begin with.
PairSetup setup_of(const Scene& scene);
/// The scene with what a person says now in place of that: poses keep their place for the size.
Scene with_setup(const Scene& scene, const PairSetup& old, const PairSetup& now);

/// Builds both bodies; the probe starts just outside the fixed body, on the side of the default
/// camera. Gains: the force limit is reached at 2 % of the probe's radius.
LoadedScene build_pair(MeshPair pair, const PairSetup& setup, const Progress& progress = {});

/// Gains that suit a probe of this size: |F| reaches its limit at a depth of 2 % of R.
Coupling suited_coupling(const MassProperties& probe);

/// A pose beside the fixed body, turned by q_FM, in the given direction from it: a plane with a gap
/// of 5 % of the probe's radius lies between the two.
Pose beside(const Body& probe, const Body& fixed, const Vec3& direction,
            const Quat& q_FM = Quat::Identity());

}  // namespace sonde::ui
