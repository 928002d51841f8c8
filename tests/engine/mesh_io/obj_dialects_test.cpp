// SPDX-License-Identifier: GPL-3.0-or-later
// Dialects of OBJ. Reference: the same mesh written plainly.
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using test::as_obj;
using test::dialect_meshes;
using test::expect_read;
using test::refusal_of;
using test::replaced;

/// The lines that begin with a keyword, each changed.
template <class F>
std::string each(const std::string& text, const std::string& keyword, const F& change) {
  std::string out;
  for (const std::string& line : test::lines_of(text))
    out += (line.starts_with(keyword + " ") ? change(line) : line) + "\n";
  return out;
}

TEST(ObjDialects, a_backslash_joins_lines_with_blanks_after_it_too) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const char* join : {" \\\n", " \\  \n", "\\\t\n  ", " \\ \r\n", " \\\r", " \\\n\\ \n"})
      expect_read("a.obj",
                  each(as_obj(mesh), "f",
                       [&](const std::string& line) {
                         std::string out = line;
                         return out.replace(out.rfind(' '), 1, join);
                       }),
                  mesh);
}

TEST(ObjDialects, a_backslash_in_a_comment_joins_nothing) {
  const PolygonSoup mesh = test::tetrahedron(1);
  for (const char* comment : {"# c:\\", "  # indented \\ ", "v 9 9 9 # after a vertex \\"}) {
    PolygonSoup want = mesh;
    const bool adds = comment[0] == 'v';
    if (adds) want.points.emplace_back(9, 9, 9);
    expect_read("a.obj",
                (adds ? "" : comment + std::string("\n")) + as_obj(mesh) +
                    (adds ? comment + std::string("\np 1\n") : ""),
                want);
  }
}

TEST(ObjDialects, faces_of_fewer_than_three_corners_are_set_aside) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    const std::string first = "line " + std::to_string(test::lines_of(as_obj(mesh)).size() + 1);
    expect_read("a.obj", as_obj(mesh) + "f 1 2\n", mesh,
                {first + ": 1 face of two corners set aside"});
    expect_read("a.obj", as_obj(mesh) + "f 1 2\nf 2/1 1/1\n", mesh,
                {first + ": 2 faces of two corners set aside"});
    expect_read("a.obj", as_obj(mesh) + "f 1\nf 1 2\nf -1", mesh,
                {first + ": 3 faces of fewer than three corners set aside"});
  }
  EXPECT_EQ(refusal_of("a.obj", "v 0 0 0\nv 1 0 0\nf 1 3\n"),
            ":3: vertex index 3 is out of range: the file has 2 vertices");
}

TEST(ObjDialects, vertices_may_have_colours_and_weights) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const char* more : {" 0.5 0.5 0.5", " 1", " 1.0", " 1 0 0 0.5", "\t255 0 0 255"})
      expect_read("a.obj",
                  each(as_obj(mesh), "v", [&](const std::string& line) { return line + more; }),
                  mesh);
  // The weight bears on curves: the point is where its coordinates are.
  expect_read("a.obj", "v 0 0 0 2\nv 1 0 0\nv 0 1 0 0.5\nf 1 2 3\n",
              {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
              {"line 1: 2 weights of vertices are not used"});
}

TEST(ObjDialects, corners_may_have_empty_parts) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const char* after : {"/", "//", "/1/", "//1", "/1/1", "/-1/-1"})
      expect_read("a.obj",
                  each(as_obj(mesh), "f",
                       [&](const std::string& line) {
                         std::string out(1, 'f');
                         out += replaced(line.substr(1), " ", after + std::string(" "))
                                    .substr(std::string(after).size());
                         return out += after;
                       }),
                  mesh);
}

TEST(ObjDialects, statements_of_other_programs_are_passed_over_and_told) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    expect_read("a.obj", "newmtl a\nKd 1 1 1\nillum 2\n" + as_obj(mesh), mesh,
                {"line 1: 3 statements of no OBJ passed over: \"newmtl\" first"});
    expect_read("a.obj", "usemap tex\ntex 1\n" + as_obj(mesh), mesh,
                {"line 2: 1 statement of no OBJ passed over: \"tex\""});
    expect_read("a.obj", "#MRGB ffffffff\nmap_Kd a b.png\n" + as_obj(mesh), mesh,
                {"line 2: 1 statement of no OBJ passed over: \"map_Kd\""});
    expect_read("a.obj", "call b.obj\n" + as_obj(mesh) + "surf 0 1 0 1 1 2\nbzp 1 2\n", mesh,
                {"line " + std::to_string(test::lines_of(as_obj(mesh)).size() + 2) +
                     ": 2 statements of free-form surfaces are not read",
                 "line 1: 1 statement that runs another file is not followed"});
  }
  for (const char* bad : {"vv 0 0 0", "V 0 0 0", "F 1 2 3", "facet normal 0 0 1", "1 2 3", "{",
                          "<html>", "\x01\x02", "s\xe4 1"})
    EXPECT_NE(refusal_of("a.obj", as_obj(test::tetrahedron(1)) + bad + "\n")
                  .find(":9: unknown statement"),
              std::string::npos)
        << bad;
}

TEST(ObjDialects, why_there_is_no_face) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(refusal_of("a.obj", v), ": the mesh has no faces");
  EXPECT_EQ(refusal_of("a.obj", v + "f 1 2\nf 2 3\n"), ":4: no face has more than two corners");
  EXPECT_EQ(refusal_of("a.obj", v + "cstype bspline\nsurf 0 1 0 1 1 2\n"),
            ":5: a free-form surface: Sonde reads polygons, and none is here");
}

}  // namespace
}  // namespace sonde
