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

/// One of the two bodies of a scene as its file describes it.
struct SceneBody {
  std::filesystem::path mesh;  ///< absolute, or relative to the working directory
  Model model = Model::automatic;
  Repair repair = Repair::automatic;
  double scale = 1;
  Pose pose;  ///< X_WM, metres
  /// By which its faces are moved outwards once it is loaded, m: the scene's `safety`, or less than
  /// zero its `allowance`. A scene file has them of the probe alone.
  double offset = 0;
  std::size_t mesh_line = 0;  ///< where the scene's file, as it was read, names the mesh
  std::filesystem::path scene_file = {};  ///< that file; of a part its body's
  std::string name = {};                  ///< of a part; empty: the mesh file's
  /// What the body is made of where that is several meshes that stand together, each at its pose in
  /// this body's mesh frame, which is the world's when the scene is read. Then `mesh` is that of
  /// the first, and `model` says nothing.
  std::vector<SceneBody> parts = {};
  // Of a part:
  std::string colour = {};  ///< in the window, "#e97d25"; empty: the window chooses
  bool shown = true;        ///< in the window
  bool felt = true;         ///< false: the body is joined without it, so that it costs nothing
  /// Which component of its mesh it is (components_of), from 1; 0: all of the mesh.
  std::size_t component = 0;
  /// Of a part or a body of one mesh: each component of the mesh is to be a part (with_components).
  bool components = false;
};
/// The name of a part: its own, or that of its file; of a component with ":" and its number.
std::string part_name(const SceneBody& part);
/// The body itself, or its parts: what names a mesh file.
std::vector<SceneBody> meshes_of(const SceneBody& body);

/// What the numbers of a body's mesh file are multiplied by: its scale times the scene's unit, or
/// its scale alone where the file states its own unit and is read in metres (has_own_unit).
double mesh_scale(const SceneBody& body, double unit);

/// Where a body or parts of it ask for their components: each of them as a part, with the looks and
/// the place of what asks; a mesh that is one component stays whole. Else the body as it is. Throws
/// as read_mesh, and InputError where they are too many or two parts come to have one name.
SceneBody with_components(const SceneBody& body, double unit, ComponentFiles& files,
                          const Progress& progress = {});

/// Loads one body of a scene, in metres, with its offset and its components. One of several parts
/// is made of what each felt part is by itself, joined (Body::parts). Throws as load_body,
/// with_components and offset_faces, and InputError where a part is to be a surface though it is
/// closed: joined to others, its inside counts.
std::shared_ptr<const Body> load(const SceneBody& body, double unit, const Progress& progress = {});

/// One part of a body of several, by itself, at its place in the body. Throws as load_body, and
/// InputError where its mesh has not so many components.
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
