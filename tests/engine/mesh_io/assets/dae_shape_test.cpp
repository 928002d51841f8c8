// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad COLLADA, with the reason that must be named.
#include "engine/mesh_io/assets/dae_shape.hpp"

#include <gtest/gtest.h>

#include "engine/mesh_io/assets/asset_readers.hpp"
#include "tests/engine/mesh_io/assets/asset_files.hpp"
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

std::string text_of(const std::string& nodes, const std::string& unit = "") {
  return test::as_dae(test::tetrahedron(0.1), unit, "Z_UP", nodes);
}
std::string said_of(const std::string& nodes, const std::string& unit = "") {
  return test::refusal_of("a.dae", text_of(nodes, unit));
}
const std::string one = "<node><instance_geometry url=\"#g\"/></node>";

TEST(DaeShape, faults) {
  EXPECT_EQ(said_of(one), "accepted");
  EXPECT_EQ(test::refusal_of("a.dae", "<X/>"), ": not a COLLADA file");
  EXPECT_EQ(said_of(one, "<unit meter=\"0\"/>"), ":3: \"0\" is no unit in metres");
  EXPECT_EQ(said_of(one, "<unit meter=\"inch\"/>"), ":3: \"inch\" is no unit in metres");
  EXPECT_EQ(said_of("<node><instance_geometry url=\"#h\"/></node>"),
            ":5: nothing in the file has the id \"h\"");
  EXPECT_EQ(test::refusal_of("a.dae", test::replaced(text_of(one), "<p>0 ", "<p>-1 ")),
            ": an index that is no count: it holds \"-\"");
  EXPECT_EQ(said_of("<node/>"), ": the file places no mesh with faces");
  const std::string cut = text_of(one).substr(0, 700);
  EXPECT_TRUE(test::refusal_of("a.dae", cut).find("not well-formed XML") != std::string::npos);
}

// assimp 5.2 reads an array without a count as empty, and then from beyond its end.
TEST(DaeShape, what_ends_the_library_is_refused) {
  const std::string text = test::replaced(text_of(one), " count=\"12\">", " co5nt=\"12\">");
  ASSERT_NE(text, text_of(one));
  EXPECT_TRUE(test::refusal_of("a.dae", text).starts_with(": cannot be read: "));
}

TEST(DaeShape, other_files) {
  EXPECT_EQ(said_of("<node><instance_geometry url=\"other.dae#g\"/></node>"),
            ":5: the file names another file, \"other.dae#g\", which is not read");
  EXPECT_EQ(said_of("<node><instance_node url=\"http://x/y.dae\"/></node>"),
            ":5: the file names another file, \"http://x/y.dae\", which is not read");
}

TEST(DaeShape, bombs) {
  std::string chain = "<node id=\"n0\"><instance_geometry url=\"#g\"/></node>";
  for (int k = 1; k < 31; ++k) {
    const std::string inner = "<instance_node url=\"#n" + std::to_string(k - 1) + "\"/>";
    chain += "<node id=\"n" + std::to_string(k) + "\">" + inner + inner + "</node>";
  }
  EXPECT_EQ(said_of(chain), ": its copies have more than 10000000 triangles in all");
  EXPECT_EQ(said_of("<node id=\"n\"><instance_node url=\"#n\"/></node>"),
            ": an object is placed inside itself");
  EXPECT_EQ(test::refusal_of("a.dae",
                             "<?xml version=\"1.0\"?>\n<!DOCTYPE x [\n<!ENTITY a \"aa\">]>"
                             "<COLLADA>&a;</COLLADA>"),
            ":3: declares an entity, which is not read");
}

}  // namespace
}  // namespace sonde
