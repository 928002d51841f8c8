// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/glb.hpp"

#include <gtest/gtest.h>

#include "tests/engine/mesh_io/assets/asset_files.hpp"
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

test::GltfFile file_of_one() { return test::gltf_of(test::tetrahedron(0.1), {{{"mesh", 0}}}, {0}); }

TEST(Glb, what_is_packed_is_found_again) {
  const std::string bytes = glb_of("{}", "12345");
  EXPECT_EQ(bytes.size() % 4, 0u);
  const Glb glb = chunks_of("f", bytes);
  EXPECT_EQ(glb.text, "{}  ");
  EXPECT_EQ(glb.data, std::string_view("12345\0\0\0", 8));
}

TEST(Glb, faults) {
  const std::string good = test::as_glb(file_of_one());
  EXPECT_EQ(test::refusal_of("a.glb", good), "accepted");
  EXPECT_EQ(test::refusal_of("a.glb", good.substr(0, 10)), ": the file is cut off in its header");
  const std::string size = std::to_string(good.size());
  EXPECT_EQ(test::refusal_of("a.glb", good.substr(0, good.size() - 4)),
            ": byte 8: the header declares " + size + " bytes, but the file has " +
                std::to_string(good.size() - 4));
  std::string other = good;
  other[4] = 1;
  EXPECT_EQ(test::refusal_of("a.glb", other), ": byte 4: version 1 of GLB: 2 is read");
  other = good;
  other[16] = 'X';
  EXPECT_EQ(test::refusal_of("a.glb", other), ": byte 12: the first chunk is not JSON");
  other = good;
  other[14] = 1;  // a chunk of 65536 bytes more
  EXPECT_EQ(test::refusal_of("a.glb", other), ": byte 12: a chunk is cut off");
}

}  // namespace
}  // namespace sonde
