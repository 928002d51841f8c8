// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad 3MF, with the reason that must be named.
#include "engine/mesh_io/assets/threemf_shape.hpp"

#include <gtest/gtest.h>

#include "engine/mesh_io/assets/asset_readers.hpp"
#include "tests/engine/mesh_io/assets/asset_files.hpp"
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

const std::string part = test::object_3mf(test::tetrahedron(10), "1");

std::string said_of(const std::string& attributes, const std::string& resources,
                    const std::string& build) {
  return test::refusal_of("a.3mf", test::as_3mf(test::xml_3mf(attributes, resources, build)));
}

TEST(ThreeMfShape, package) {
  EXPECT_EQ(said_of("", part, "<item objectid=\"1\"/>"), "accepted");
  EXPECT_EQ(test::refusal_of("a.3mf", test::as_zip({{"a", "b"}})),
            ": not a 3MF file: it does not say where its model is");
  EXPECT_EQ(test::refusal_of(
                "a.3mf",
                test::as_zip(
                    {{"_rels/.rels", "<R><Relationship Target=\"/x\" Type=\"y/3dmodel\"/></R>"}})),
            ": the package has no part \"x\", its model");
}

TEST(ThreeMfShape, model) {
  EXPECT_EQ(said_of("unit=\"yard\"", part, "<item objectid=\"1\"/>"),
            ": 3D/part.model:2: \"yard\" is no unit of 3MF");
  EXPECT_EQ(said_of("", part, "<item objectid=\"2\"/>"),
            ": 3D/part.model:4: no object has the id \"2\"");
  EXPECT_EQ(said_of("", part, ""), ": the file places no mesh with faces");
  EXPECT_EQ(said_of("", part, "<item objectid=\"1\" p:path=\"/3D/other.model\" xmlns:p=\"p\"/>"),
            ": 3D/part.model:4: an object in another part of the package, \"/3D/other.model\", is "
            "not read: export it as one model");
  EXPECT_EQ(said_of("requiredextensions=\"m s\" xmlns:m=\"http://x/material/2\" "
                    "xmlns:s=\"http://x/slice/1\"",
                    part, "<item objectid=\"1\"/>"),
            ": 3D/part.model:2: the file requires the extension \"http://x/slice/1\", which is not "
            "read");
  EXPECT_TRUE(said_of("", "<object", "").starts_with(": 3D/part.model:3: not well-formed XML: "));
}

TEST(ThreeMfShape, numbers) {
  const auto said = [](const std::string& from, const std::string& to) {
    const std::string bad = test::replaced(part, from, to);
    EXPECT_NE(bad, part);
    return said_of("", bad, "<item objectid=\"1\"/>");
  };
  for (const char* corner : {"4", "-1", "4000000000", "4294967296", "x", "", "1.5"})
    EXPECT_EQ(said("v1=\"0\"", std::string("v1=\"") + corner + "\""),
              ": 3D/part.model:3: \"" + std::string(corner) + "\" is none of the 4 vertices");
  for (const char* number : {"1,5", "abc", ""})
    EXPECT_EQ(said("x=\"5\" y=\"-5\"", std::string("x=\"") + number + "\" y=\"0\""),
              ": 3D/part.model:3: \"" + std::string(number) + "\" is not a number");
  EXPECT_EQ(said_of("", part, "<item objectid=\"1\" transform=\"1 0 0 0 1 0\"/>"),
            ": 3D/part.model:4: a transform of 6 numbers, not 12");
  EXPECT_EQ(said_of("x:unit=\"yard\" unit=\"inch\" xmlns:x=\"x\"", part, "<item objectid=\"1\"/>"),
            "accepted");
}

TEST(ThreeMfShape, bombs) {
  std::string chain = part;
  for (int k = 2; k < 32; ++k) {
    const std::string inner = "<component objectid=\"" + std::to_string(k - 1) + "\"/>";
    chain += "<object id=\"" + std::to_string(k) + "\"><components>" + inner + inner +
             "</components></object>";
  }
  EXPECT_EQ(said_of("", chain, "<item objectid=\"31\"/>"),
            ": 3D/part.model: its copies have more than 10000000 triangles in all");
  EXPECT_EQ(said_of("", chain, "<item objectid=\"5\"/>"), "accepted");
  EXPECT_EQ(
      said_of("", "<object id=\"1\"><components><component objectid=\"1\"/></components></object>",
              "<item objectid=\"1\"/>"),
      ": 3D/part.model: an object is placed inside itself");
}

}  // namespace
}  // namespace sonde
