// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "engine/body/body.hpp"
#include "tests/support/real_meshes.hpp"

namespace sonde {
namespace {

/// What a person who looks at them takes the open ones for: sheets, shells, and vessels; those with
/// a hole that one sees, which may be either, and of which the program says that it took them for
/// surfaces.
const std::set<std::string> surfaces{"ALSTOM_TEST4.off",
                                     "cylinder.off",
                                     "cylinder_locally_refined.off",
                                     "degtri_sliding.off",
                                     "fold.off",
                                     "holes.off",
                                     "horizons.off",
                                     "in.off",
                                     "mask_cone.off",
                                     "mesh_with_border.off",
                                     "mesh_with_colors.off",
                                     "mushroom.off",
                                     "nefertiti.off",
                                     "negative.off",
                                     "patch-01.off",
                                     "patch-13.off",
                                     "patch-20.off",
                                     "patch-21.off",
                                     "patch-23.off",
                                     "patch-30.off",
                                     "plane.off",
                                     "poly2x^2+y^2-0.062500.off",
                                     "polygon_mesh.off",
                                     "quad.off",
                                     "quads_to_stitch.off",
                                     "three_peaks.off",
                                     "triangle.off",
                                     "triangular_hole.off",
                                     "cube-ouvert.off",
                                     "open_cube.off",
                                     "hedra_open.off"};
const std::set<std::string> either{"blob.off",
                                   "blobby_3cc.off",
                                   "corner_tris_with_hole.off",
                                   "corner_with_hole.off",
                                   "double-torus-3-holes.off",
                                   "head.off",
                                   "lion-head.off",
                                   "lion.off",
                                   "mannequin-devil.off",
                                   "mech-holes-shark.off"};

// Reference: a look at each. All others are solids to whoever looks at them.
TEST(Decisions, real_meshes_are_what_a_person_takes_them_for) {
  std::size_t looked = 0;
  for (const auto& file : test::real_meshes()) {
    const std::string name = file.filename().string();
    std::shared_ptr<const Body> body;
    try {
      body = load_body(file.string(), Model::automatic);
    } catch (const InputError&) {
      continue;  // a few are no meshes
    }
    ++looked;
    // The threshold lies in a gap: nothing is a surface by little.
    EXPECT_TRUE(body->repairs.widest_mouth == 0 || body->repairs.widest_mouth > 0.05) << name;
    if (either.contains(name)) {
      EXPECT_FALSE(body->solid) << name;
      EXPECT_TRUE(body->repairs.could_be_solid) << name;
      EXPECT_NE(body->why.find("open mouth"), std::string::npos) << name;
    } else {
      EXPECT_EQ(body->solid, !surfaces.contains(name)) << name << ": " << body->why;
    }
  }
  EXPECT_GE(looked, 130u);
}

}  // namespace
}  // namespace sonde
