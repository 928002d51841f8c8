// SPDX-License-Identifier: GPL-3.0-or-later
// Dialects of OFF. Reference: the same mesh written plainly.
#include "tests/engine/mesh_io/mesh_checks.hpp"

namespace sonde {
namespace {

using test::dialect_meshes;
using test::expect_read;
using test::refusal_of;

/// The parts of a plain file: with other counts, numbers after the vertices and after the faces.
struct OffText {
  std::string start = "OFF\n";
  std::string edges = " 0\n";
  std::string after_vertex = "\n";
  std::string after_face = "\n";
};

std::string written(const PolygonSoup& mesh, const OffText& text) {
  const std::vector<std::string> lines = test::lines_of(test::as_off(mesh));
  std::string out = text.start + std::to_string(mesh.points.size()) + " " +
                    std::to_string(mesh.polygons.size()) + text.edges;
  for (std::size_t i = 2; i < lines.size(); ++i)
    out += lines[i] + (i < 2 + mesh.points.size() ? text.after_vertex : text.after_face);
  return out;
}

TEST(OffDialects, attributes_in_any_order) {
  struct Case {
    const char* keyword;
    const char* numbers;
  };
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const Case& c : {Case{"NOFF", " 0 0 1\n"},
                          {"COFF", " 255 0 0 255\n"},
                          {"STOFF", " 0 1\n"},
                          {"CNOFF", " 0 0 1 1 0 0 1\n"},
                          {"NCOFF", " 0 0 1 255 0 0 255\n"},
                          {"STCNOFF", " 1 1 1 1 0 0 1 0 1\n"},
                          {"STNCOFF", " 1 1 1 1 0 0 1 0 1\n"},
                          {"NSTOFF", " 1 1 1 0 1\n"},
                          {"NCSTOFF", " 1 1 1 1 0 0 1 0 1\n"}})
      expect_read("a.off", written(mesh, {c.keyword + std::string("\n"), " 0\n", c.numbers, "\n"}),
                  mesh);
  EXPECT_EQ(refusal_of("a.off", "CCOFF\n3 1 0\n"), ":1: not an OFF file: it starts with \"CCOFF\"");
}

TEST(OffDialects, more_or_fewer_numbers_than_announced) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    const auto remark = [](int n, int announced) {
      return std::vector{"line 3: the vertices have " + std::to_string(n) +
                         " numbers after their coordinates, not the " + std::to_string(announced) +
                         " that the keyword announces"};
    };
    expect_read("a.off", written(mesh, {"OFF\n", " 0\n", " 255 0 0 255\n", "\n"}), mesh,
                remark(4, 0));
    expect_read("a.off", written(mesh, {"OFF\n", " 0\n", " 0.5 0 1\n", "\n"}), mesh, remark(3, 0));
    expect_read("a.off", written(mesh, {"OFF\n", " 0\n", " 0 0 1 1 0 0 1\n", "\n"}), mesh,
                remark(7, 0));
    expect_read("a.off", written(mesh, {"COFF\n", " 0\n", " 255 0 0\n", "\n"}), mesh, remark(3, 4));
    expect_read("a.off", written(mesh, {"CNOFF\n", " 0\n", " 0 0 1 255 0 0\n", "\n"}), mesh,
                remark(6, 7));
    expect_read("a.off", written(mesh, {"NOFF\n", " 0\n", "\n", "\n"}), mesh, remark(0, 3));
  }
  EXPECT_EQ(refusal_of("a.off", "OFF\n3 1 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n"),
            ":3: three coordinates expected, but the line has more");
  EXPECT_EQ(refusal_of("a.off", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0\n0 1 0 0 0 1\n3 0 1 2\n"),
            ":4: 2 numbers after the coordinates, where the first vertex has 3");
}

TEST(OffDialects, colours_after_the_corners) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const char* colour : {" 255 0 0\n", " 0.5 0.5 0.5 1.0\n", " 7\n", " # red\n", "\t1 0 0\n"})
      expect_read("a.off", written(mesh, {"OFF\n", " 0\n", "\n", colour}), mesh);
}

TEST(OffDialects, keywords) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    expect_read("a.off", written(mesh, {"", " 0\n", "\n", "\n"}), mesh,
                {"line 1: no keyword, read as \"OFF\""});
    expect_read("a.off", written(mesh, {"# a\n", "\n", "\n", "\n"}), mesh,
                {"line 2: no keyword, read as \"OFF\""});
    expect_read("a.off", written(mesh, {"off\n", " 0\n", "\n", "\n"}), mesh,
                {"line 1: the keyword \"off\" is read as \"OFF\""});
    expect_read("a.off", written(mesh, {"Off ", " 0\n", "\n", "\n"}), mesh,
                {"line 1: the keyword \"Off\" is read as \"OFF\""});
    expect_read("a.off", written(mesh, {"coff\n", " 0\n", " 1 0 0 1\n", "\n"}), mesh,
                {"line 1: the keyword \"coff\" is read as \"COFF\""});
  }
}

TEST(OffDialects, counts_where_they_are) {
  for (const PolygonSoup& mesh : dialect_meshes())
    for (const OffText& text : {OffText{"OFF ", " 0\n"},
                                {"OFF ", "\n"},
                                {"OFF\n", "\n"},
                                {"OFF\n", "\n18\n"},
                                {"OFF # the kind\n", " 0 # counts\n\n"},
                                {"\n\n OFF\n\n", "\t12 \n"},
                                {"OFF\n", " -1\n"}})
      expect_read("a.off", written(mesh, text), mesh);
  const std::string text = written(test::tetrahedron(1), {});
  std::string apart = text;
  expect_read("a.off", apart.replace(4, 5, "4\n4\n0"), test::tetrahedron(1));
}

TEST(OffDialects, everything_in_one_line_or_in_other_lines) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    const std::string text = written(mesh, {});
    expect_read("a.off", test::replaced(text, "\n", " "), mesh);
    expect_read("a.off", test::replaced(text, "\n", " ") + "\n", mesh);
    expect_read("a.off", test::replaced(text, " ", "\n"), mesh);
    expect_read("a.off", test::replaced(written(mesh, {"OFF ", " "}), "\n", " "),
                mesh);  // no edges
    expect_read("a.off", test::replaced(written(mesh, {"NOFF ", " 0 ", " 0 0 1\n"}), "\n", " "),
                mesh);
    expect_read("a.off", written(mesh, {"OFF\n", " 0\n", " "}), mesh);  // the vertices in one line
  }
  const std::string text = test::replaced(written(test::tetrahedron(1), {}), "\n", " ");
  EXPECT_NE(refusal_of("a.off", text.substr(0, text.size() - 3)), "accepted");
  EXPECT_EQ(refusal_of("a.off", text + "3 0 1 2"),
            ":1: data after the last of the 4 declared faces");
  EXPECT_EQ(refusal_of("a.off", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 3"),
            ":1: vertex index 3 is out of range (0 to 2)");
  EXPECT_EQ(refusal_of("a.off", "OFF 1000000000 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2"),
            ":1: the header declares 1000000000 vertices and 1 faces, but only 25 bytes follow");
}

TEST(OffDialects, faces_of_fewer_than_three_corners_are_set_aside) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    PolygonSoup more = mesh;
    const std::size_t line = 3 + mesh.points.size();
    more.polygons.insert(more.polygons.begin(), {0, 1});
    expect_read("a.off", test::as_off(more), mesh,
                {"line " + std::to_string(line) + ": 1 face of two corners set aside"});
    more.polygons.push_back({2});
    expect_read(
        "a.off", test::as_off(more), mesh,
        {"line " + std::to_string(line) + ": 2 faces of fewer than three corners set aside"});
    PolygonSoup binary = mesh;
    binary.polygons.insert(binary.polygons.begin(), {0, 1});
    expect_read("b.off", test::as_binary_off(binary), mesh,
                {"byte " + std::to_string(23 + 12 * mesh.points.size()) +
                 ": 1 face of two corners set aside"});
  }
  EXPECT_EQ(refusal_of("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"),
            ":6: no face has more than two corners");
  EXPECT_EQ(refusal_of("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n2 0 3\n3 0 1 2\n"),
            ":6: vertex index 3 is out of range (0 to 2)");
}

TEST(OffDialects, binary_in_other_orders_and_with_an_end) {
  for (const PolygonSoup& mesh : dialect_meshes()) {
    expect_read("a.off", test::as_binary_off(mesh, "NC", 7), mesh);
    expect_read("a.off", test::as_binary_off(mesh, "NST", 5), mesh);
    expect_read("a.off", test::as_binary_off(mesh) + "\r\n", mesh,
                {"2 bytes after the mesh, zeros or blanks, are not read"});
  }
}

}  // namespace
}  // namespace sonde
