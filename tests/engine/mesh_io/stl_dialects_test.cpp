// SPDX-License-Identifier: GPL-3.0-or-later
// Dialects of STL. Reference: the same mesh written plainly.
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using namespace std::string_literals;
using test::dialect_meshes;
using test::expect_read;
using test::refusal_of;
using test::replaced;

std::string with_count(std::string bytes, std::uint32_t count) {
  return bytes.replace(80, 4, test::raw(count));
}

PolygonSoup plainly(const PolygonSoup& mesh) {
  return test::read_bytes_as("a.stl", test::as_binary_stl(mesh));
}

TEST(StlDialects, bytes_after_the_last_triangle) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const char* title : {"a test", "solid exported by X", "COLOR=\xff\xff\xff\xff,MATERIAL="})
      for (const std::string& tail :
           {"\r\n"s, std::string(30, '\0'), "made by X"s, std::string(100, '\0')})
        expect_read("a.stl", test::as_binary_stl(mesh, title) + tail, plainly(mesh),
                    {std::to_string(tail.size()) + " bytes after the last triangle are not read"});
  // As many as a triangle has may be one that the count leaves out.
  const std::string bytes = test::as_binary_stl(test::tetrahedron(1));
  EXPECT_EQ(refusal_of("a.stl", with_count(bytes, 3)),
            ": byte 80: the header declares 3 triangles, that is 234 bytes, but the file has 284");
}

TEST(StlDialects, a_count_that_was_not_filled_in) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const std::uint32_t count : {0u, 0xffffffffu})
      for (const char* title : {"a test", "solid, but binary"}) {
        const std::string bytes = with_count(test::as_binary_stl(mesh, title), count);
        const std::string said = "byte 80: the header declares " + std::to_string(count) +
                                 " triangles; by its size the file has " +
                                 std::to_string(mesh.polygons.size());
        expect_read("a.stl", bytes, plainly(mesh), {said});
        expect_read("a.stl", bytes + "\n", plainly(mesh),
                    {said, "1 byte after the last triangle is not read"});
        EXPECT_EQ(refusal_of("a.stl", bytes + "more").substr(0, 33),
                  ": byte 80: the header declares " + std::to_string(count).substr(0, 1) +
                      (count == 0 ? " " : "2"));
      }
}

TEST(StlDialects, attributes_of_triangles) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    std::string bytes = test::as_binary_stl(mesh);
    for (std::size_t i = 0; i < mesh.polygons.size(); ++i)
      bytes.replace(84 + 50 * i + 48, 2, "\xff\x7f");
    expect_read("a.stl", bytes, plainly(mesh));
  }
}

TEST(StlDialects, text_without_its_end) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    const std::string text = test::as_text_stl(mesh);
    const std::string cut = text.substr(0, text.rfind("endsolid"));
    // The last line that there is: of the header's, and seven for each triangle.
    const std::size_t last = 1 + 7 * plainly(mesh).polygons.size();
    const auto said = [](std::size_t line) {
      return "line " + std::to_string(line) + ": the file ends before \"endsolid\"; is it whole?";
    };
    expect_read("a.stl", cut, plainly(mesh), {said(last)});
    expect_read("a.stl", cut + "\n\n", plainly(mesh), {said(last + 2)});
    EXPECT_EQ(refusal_of("a.stl", cut.substr(0, cut.rfind("endfacet"))),
              ":" + std::to_string(last) + ": \"endfacet\" is expected, but the file ends");
  }
}

TEST(StlDialects, names_cases_and_colours) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    const std::string text = test::as_text_stl(mesh);
    const auto named = [&](const std::string& name) {
      return replaced(text, "solid a test", "solid" + name);
    };
    for (const std::string& name :
         {""s, " "s + std::string(4000, 'x'), " Geh\xe4use"s, " W\xc3\xbcrfel 1"s})
      expect_read("a.stl", named(name), plainly(mesh));
    std::string upper = text;
    for (char& c : upper) c = static_cast<char>(std::toupper(c));
    expect_read("a.stl", upper, plainly(mesh));
    expect_read("a.stl", "\n\n   " + text, plainly(mesh));
    expect_read("a.stl", replaced(text, "  facet", "color 0.5 0 0\n  facet"), plainly(mesh));
    expect_read("a.stl", replaced(text, "    outer", "    color 0.5 0 0 1\n    outer"),
                plainly(mesh));
  }
}

TEST(StlDialects, several_solids) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    PolygonSoup twice = mesh;
    twice.polygons.insert(twice.polygons.end(), mesh.polygons.begin(), mesh.polygons.end());
    const std::string text = test::as_text_stl(mesh);
    expect_read("a.stl", text + "\n" + text, plainly(twice));
    expect_read("a.stl", text + replaced(text, "a test", "another"), plainly(twice));
  }
}

}  // namespace
}  // namespace sonde
