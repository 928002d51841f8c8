// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad glTF, with the reason that must be named.
#include "engine/mesh_io/assets/gltf_shape.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "engine/mesh_io/assets/asset_readers.hpp"
#include "tests/engine/mesh_io/assets/asset_files.hpp"
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using nlohmann::json;

test::GltfFile tetrahedron() { return test::gltf_of(test::tetrahedron(0.1), {{{"mesh", 0}}}, {0}); }

std::string said(const std::function<void(json&)>& change) {
  test::GltfFile file = tetrahedron();
  change(file.tree);
  return test::refusal_of("a.glb", test::as_glb(file));
}

TEST(GltfShape, no_gltf) {
  EXPECT_EQ(test::refusal_of("a.gltf", "[]"), ": not a glTF file");
  EXPECT_EQ(test::refusal_of("a.gltf", "{}"), ": not a glTF file: it says no version");
}

TEST(GltfShape, lies) {
  EXPECT_EQ(said([](json& t) { t["accessors"][0]["count"] = 4000000000; }),
            ":1: 4000000000 elements are declared, and their data are shorter");
  EXPECT_EQ(said([](json& t) { t["accessors"][0].erase("bufferView"); }),
            ":1: an accessor without data");
  EXPECT_EQ(said([](json& t) { t["accessors"][0]["componentType"] = 5123; }),
            ":1: positions that are not three floats are not read");
  EXPECT_EQ(said([](json& t) { t["bufferViews"][1]["byteLength"] = 1000; }),
            ":1: a view of a buffer ends after the buffer");
  EXPECT_EQ(said([](json& t) { t["buffers"][0]["byteLength"] = 1000; }),
            ":1: the buffer declares 1000 bytes, and there are 72");
  EXPECT_EQ(said([](json& t) { t["nodes"][0]["mesh"] = 7; }),
            ":1: mesh 7 is named, and there are 1");
  EXPECT_EQ(said([](json& t) { t["nodes"][0]["mesh"] = -1; }), ":1: \"mesh\" is no count");
  EXPECT_EQ(said([](json& t) {
              t["nodes"][0]["scale"] = {1, 2};
            }),
            ":1: \"scale\" has 2 numbers, not 3");
  EXPECT_EQ(said([](json& t) { t["scenes"][0]["nodes"] = json::array(); }),
            ": the file places no mesh with faces");
  test::GltfFile file = tetrahedron();
  file.data[48] = 9;  // a corner of the first triangle: there are four
  EXPECT_EQ(test::refusal_of("a.glb", test::as_glb(file)),
            ": of 12 corners of faces 9 can be read");
}

TEST(GltfShape, other_files) {
  EXPECT_EQ(said([](json& t) { t["buffers"][0]["uri"] = "other.bin"; }),
            ":1: the data lie in another file, \"other.bin\": save it as GLB, or with the data "
            "inside");
  test::GltfFile file = tetrahedron();
  EXPECT_EQ(test::refusal_of("a.gltf", file.tree.dump()), ":1: a buffer without data");
  file.tree["buffers"][0]["byteLength"] = 400;
  EXPECT_EQ(test::refusal_of("a.gltf", test::as_gltf(file)), ":1: the data are cut off");
}

TEST(GltfShape, extensions_that_bear_on_the_shape) {
  EXPECT_EQ(said([](json& t) { t["extensionsRequired"] = {"EXT_meshopt_compression"}; }),
            ":1: the file requires the extension \"EXT_meshopt_compression\", which is not read");
  EXPECT_EQ(said([](json& t) { t["extensionsUsed"] = {"EXT_mesh_gpu_instancing"}; }),
            ":1: the file places copies by EXT_mesh_gpu_instancing, which is not read");
  EXPECT_EQ(
      said([](json& t) { t["extensionsRequired"] = {"KHR_draco_mesh_compression"}; }),
      ":1: the file requires the extension \"KHR_draco_mesh_compression\", which is not read");
  EXPECT_EQ(said([](json& t) { t["extensionsRequired"] = {"KHR_materials_unlit"}; }), "accepted");
}

/// A kilobyte that asks for 2^30 copies.
TEST(GltfShape, a_bomb_of_copies) {
  const auto chain = [](json& tree, int length) {
    tree["nodes"] = json::array();
    for (int k = 0; k < length; ++k) tree["nodes"].push_back({{"children", {k + 1, k + 1}}});
    tree["nodes"].push_back({{"mesh", 0}});
  };
  EXPECT_EQ(said([&](json& t) { chain(t, 30); }),
            ": its copies have more than 10000000 triangles in all");
  EXPECT_EQ(said([&](json& t) { chain(t, 5); }), "accepted");
  EXPECT_EQ(said([](json& t) {
              t["nodes"] = {{{"children", {0}}}};
            }),
            ": an object is placed inside itself");
}

}  // namespace
}  // namespace sonde
