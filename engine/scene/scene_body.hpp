// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/scene/component_files.hpp"

namespace sonde {

/// One of the two bodies of a scene, as described in its file.
struct SceneBody {
  std::filesystem::path mesh;  ///< absolute, or relative to the working directory
  Model model = Model::automatic;
  Repair repair = Repair::automatic;
  double scale = 1;
  Pose pose;  ///< X_WM, metres
  /// m: outward offset of its faces, applied after loading: the scene's `safety`, or minus its
  /// `allowance`. A scene file has them for the probe only.
  double offset = 0;
  std::size_t mesh_line = 0;  ///< where the scene's file, as it was read, names the mesh
  std::filesystem::path scene_file = {};  ///< that file; of a part its body's
  std::string name = {};                  ///< of a part; empty: the mesh file's
  /// What the body is made of where that is several meshes that stand together, each at its pose in
  /// this body's mesh frame, which is the world's when the scene is read. Then `mesh` is that of
  /// the first, and `model` says nothing.
  std::vector<SceneBody> parts = {};
  // For a part only:
  std::string colour = {};  ///< in the window, "#e97d25"; empty: the window chooses
  bool shown = true;        ///< in the window
  bool felt = true;         ///< false: the body is joined without it, so it costs nothing
  /// The component of its mesh that it is (components_of), from 1; 0: the whole mesh.
  std::size_t component = 0;
  /// For a part, or a body of one mesh: each component of the mesh becomes a part
  /// (with_components).
  bool components = false;
};
/// The name of a part: its own, or its file's; for a component with ":" and its number.
std::string part_name(const SceneBody& part);
/// The body itself, or its parts: the objects that name mesh files.
std::vector<SceneBody> meshes_of(const SceneBody& body);

/// The factor on the coordinates of a body's mesh file: its scale times the scene's unit, or its
/// scale only, if the file states its own unit and is read in metres (has_own_unit).
double mesh_scale(const SceneBody& body, double unit);

/// If a body or parts of it request their components: the body with each component as a part, with
/// the appearance and pose of the requesting object; a mesh with a single component stays whole.
/// Otherwise the body unchanged. Throws as read_mesh does, and InputError if there are too many
/// components or two parts would have the same name.
SceneBody with_components(const SceneBody& body, double unit, ComponentFiles& files,
                          const Progress& progress = {});

/// Loads one body of a scene, in metres, with its offset and its components. A body of several
/// parts is joined from its felt parts (Body::parts). Throws as load_body, with_components and
/// offset_faces do, and InputError if a part is declared a surface although it is closed: joined to
/// others, its inside counts.
std::shared_ptr<const Body> load(const SceneBody& body, double unit, const Progress& progress = {});

/// One part of a body of several, at its pose in the body. Throws as load_body does, and InputError
/// if its mesh does not have that many components.
BodyPart load_part(const SceneBody& whole, std::size_t part, double unit, ComponentFiles& files,
                   const Progress& progress = {});
/// The parts with these numbers as load_part has them, on all threads; the others are without a
/// body. Those that are alike (a screw, many times) are one body. Throws as load_part does for the
/// first of them that is wrong.
std::vector<BodyPart> load_parts(const SceneBody& whole, const std::vector<std::size_t>& wanted,
                                 double unit, ComponentFiles& files, const Progress& progress = {});
/// The body that its felt parts make together, with its offset. `parts`: each of `whole.parts` as
/// load_part has it; those that are not felt may be without a body. Throws as load, and InputError
/// where none is felt.
std::shared_ptr<const Body> join(const SceneBody& whole, const std::vector<BodyPart>& parts,
                                 const Progress& progress = {});

}  // namespace sonde
