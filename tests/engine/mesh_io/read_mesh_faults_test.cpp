// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of bad mesh file, with the place and the reason that must be named.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <functional>
#include <limits>
#include <utility>

#include "engine/mesh_io/read_mesh.hpp"
#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::TempFolder;

/// What is said of a file, without its name.
std::string said_of(const std::filesystem::path& file) {
  try {
    read_mesh(file);
  } catch (const InputError& e) {
    const std::string what = e.what(), name = file.string();
    EXPECT_TRUE(what.starts_with(name)) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << "one line";
    return what.substr(name.size());
  }
  return "accepted";
}

std::string said(const std::string& name, const std::string& bytes) {
  const TempFolder folder;
  return said_of(folder.write(name, bytes));
}

struct Fault {
  std::string text;
  std::string message;
};

void check(const std::string& name, const std::vector<Fault>& faults) {
  for (const Fault& fault : faults) EXPECT_EQ(said(name, fault.text), fault.message) << fault.text;
}

TEST(MeshFaults, files) {
  const TempFolder folder;
  EXPECT_EQ(said_of(folder.path() / "none.off"), ": no such file");
  EXPECT_EQ(said_of(folder.write("empty.obj", "")), ": the file is empty");
  std::filesystem::create_directory(folder.path() / "folder.ply");
  EXPECT_EQ(said_of(folder.path() / "folder.ply"), ": not a regular file");
  ASSERT_EQ(::mkfifo((folder.path() / "pipe.stl").c_str(), 0600), 0);
  EXPECT_EQ(said_of(folder.path() / "pipe.stl"), ": not a regular file");
  for (const char* name : {"mesh.xyz", "mesh", "off", "mesh.off.gz"})
    EXPECT_EQ(said_of(folder.write(name, "OFF")),
              ": unknown mesh format: OFF, OBJ, PLY, STL, GLB, glTF, 3MF and DAE are read");
}

TEST(MeshFaults, off) {
  check(
      "a.off",
      {{"# nothing\n\n", ": the file holds nothing but comments"},
       {"oft\n3 1 0\n", ":1: not an OFF file: it starts with \"oft\""},
       {"off\n3 1 0\n", ":2: the header declares 3 vertices and 1 faces, but only 0 bytes follow"},
       {"\x01\x02junk\n", ":1: not an OFF file: it starts with \"\\x01\\x02junk\""},
       {"4OFF\n3 1 0\n", ":1: the 4OFF variant of OFF is not supported"},
       {"nOFF\n3\n3 1 0\n", ":1: the nOFF variant of OFF is not supported"},
       {"SKEL\n", ":1: the SKEL variant of OFF is not supported"},
       {"OFF\n", ":1: the file ends before the number of vertices"},
       {"OFF\n3\n", ":2: the line ends where a number of faces is expected"},
       {"OFF\nx 1 0\n", ":2: \"x\" is not a number of vertices"},
       {"OFF\n-3 1 0\n", ":2: \"-3\" is not a number of vertices"},
       {"OFF\n0 0 0\n", ":2: the mesh has no vertices"},
       {"OFF\n1 0 0\n0 0 0\n", ":2: the mesh has no faces"},
       {"OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", ":4: three coordinates expected"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n",
        ":4: three coordinates expected, but the line has more"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0,5\n0 1 0\n3 0 1 2\n",
        ":4: \"0,5\" is not a number: decimals take a point, no comma"},
       {"OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", ":4: the coordinate \"nan\" is not finite"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n-inf 1 0\n3 0 1 2\n",
        ":5: the coordinate \"-inf\" is not finite"},
       {"OFF\n3 1 0\n0 0 0\n1 0 1e999\n0 1 0\n3 0 1 2\n",
        ":4: the coordinate \"1e999\" is not finite"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
        ":6: vertex index 3 is out of range (0 to 2)"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n",
        ":6: vertex index -1 is out of range (0 to 2)"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2.5\n", ":6: \"2.5\" is not a vertex index"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n",
        ":6: the line ends where a vertex index is expected"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", ":6: no face has more than two corners"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n99999999999999999999 0 1\n",
        ":6: \"99999999999999999999\" is not a number of corners"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0 0 0 0 0\n",
        ":6: more numbers than the corners and a colour"},
       {"OFF\n3 1 0\n0.0000 0.0000 0.0000\n1 0 0\n",
        ":4: the file ends after 2 of 3 declared vertices"},
       {"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        ":6: the file ends after 1 of 2 declared faces"},
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\n3 2 1 0\n",
        ":8: data after the last of the 1 declared faces"}});
}

TEST(MeshFaults, off_binary) {
  PolygonSoup triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.polygons = {{0, 1, 2}};
  const std::string good = test::as_binary_off(triangle);
  const std::size_t start = 11, face = start + 12 + 36;  // "OFF BINARY\n", counts, points
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(good).replace(at, bytes.size(), bytes);
  };
  const auto whole = [](std::uint32_t n) { return test::raw(n, true); };
  const std::string nan = test::raw(std::numeric_limits<float>::quiet_NaN(), true);
  check("a.off",
        {{good, "accepted"},
         {good.substr(0, 14), ": byte 14: the file ends inside the numbers of vertices and faces"},
         {with(start, whole(0)), ": byte 11: the mesh has no vertices"},
         {with(start + 4, whole(0)), ": byte 11: the mesh has no faces"},
         {with(start, whole(0xffffffff)),
          ": byte 11: the header declares 4294967295 vertices and 1 faces, but only 68 bytes "
          "follow"},
         {with(start + 12 + 16, nan), ": byte 39: a coordinate of vertex 2 of 3 is not finite"},
         {with(face, whole(2)), ": byte 59: no face has more than two corners"},
         {with(face, whole(0xffffffff)), ": byte 91: the file ends inside face 1 of 1"},
         {with(face + 8, whole(3)),
          ": byte 67: vertex index 3 in face 1 of 1 is out of range (0 to 2)"},
         {with(face + 16, whole(0xffffffff)), ": byte 91: the file ends inside face 1 of 1"},
         {good + "x", ": byte 91: 1 bytes more than the header declares"}});
}

TEST(MeshFaults, obj) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check("a.obj",
        {{"# nothing\n", ": the mesh has no vertices"},
         {v, ": the mesh has no faces"},
         {v + "l 1 2\n", ": the mesh has no faces"},
         {"f 1 2 3\n", ":1: vertex index 3 is out of range: the file has 0 vertices"},
         {"v 0 0\n", ":1: three coordinates expected"},
         {"v 0 x 0\n", ":1: \"x\" is not a number"},
         {"v 0 0 NaN\n", ":1: the coordinate \"NaN\" is not finite"},
         {v + "f 0 1 2\n", ":4: vertex index 0: the vertices of OBJ count from 1"},
         {v + "f 1 2 4\nf 1 2 3\n", ":4: vertex index 4 is out of range: the file has 3 vertices"},
         {v + "f 1 2 -4\nv 0 0 0\n",
          ":4: vertex index -4 is out of range: there are 3 vertices so far"},
         {v + "f 1 2\n", ":4: no face has more than two corners"},
         {v + "f\n", ":4: a face without corners"},
         {v + "f 1 2 3x\n", ":4: \"3x\" is not a vertex index"},
         {v + "f 1 2 3/x\n", ":4: \"3/x\" is not a corner of a face"},
         {v + "f 1 2 3/1/1/1\n", ":4: \"3/1/1/1\" is not a corner of a face"},
         {v + "f 1 2 /3\n", ":4: \"/3\" is not a corner of a face"},
         {v + "f 1 2 99999999999999999999\n", ":4: \"99999999999999999999\" is not a vertex index"},
         {"# a\n\nvv 0 0 0\n", ":3: unknown statement \"vv\""},
         {"v 0 0 0\nv 1 \\\n0 x\n", ":2: \"x\" is not a number"}});
}

std::string ply(const std::string& elements, const std::string& body,
                const std::string& format = "ascii") {
  return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n" + body;
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string corners = "property list uchar int vertex_indices\n";
const std::string usual = "element vertex 3\n" + xyz + "element face 1\n" + corners;
const std::string points = "0 0 0\n1 0 0\n0 1 0\n";

TEST(MeshFaults, ply_header) {
  check(
      "a.ply",
      {{"plx\n", ":1: not a PLY file: it must start with \"ply\""},
       {"ply\n", ":1: \"format\" is expected"},
       {"ply\nformat utf8 1.0\n", ":2: unknown format \"utf8\""},
       {"ply\nformat ascii 1.0\nelement vertex 3\n", ":3: the file ends inside the header"},
       {ply("elephant\n", ""), ":3: unknown header line \"elephant\""},
       {ply("property float x\n", ""), ":3: a property before the first element"},
       {ply("element vertex x\n", ""), ":3: \"x\" is not a number of elements"},
       {ply("element vertex -1\n", ""), ":3: \"-1\" is not a number of elements"},
       {ply("element vertex 1\nproperty half x\n", ""), ":4: \"half\" is not a type"},
       {ply("element vertex 1\nproperty float\n", ""), ":4: the property has no name"},
       {ply("element face 1\nproperty list float int vertex_indices\n", ""),
        ":5: the mesh has no vertices"},
       {ply("element face 1\nproperty list uchar float vertex_indices\n", ""),
        ":5: the mesh has no vertices"},
       {ply("element face 1\nproperty list uchar short vertex_indices\n", "",
            "binary_little_endian"),
        ":5: the mesh has no vertices"},
       {ply("element vertex 1\nproperty int x\n", "", "binary_little_endian"),
        ":5: the mesh has no faces"},
       {ply("element vertex 3\nproperty float x\nproperty float y\nelement face 1\n" + corners, ""),
        ":3: the vertices lack x, y or z"},
       {ply("element vertex 3\n" + xyz + "element face 1\nproperty uchar red\n", ""),
        ":7: the faces lack vertex_indices"},
       {ply("element face 1\n" + corners, points), ":5: the mesh has no vertices"},
       {ply("element vertex 3\n" + xyz, points), ":7: the mesh has no faces"},
       {ply("element vertex 0\n" + xyz + "element face 1\n" + corners, "3 0 1 2\n"),
        ":9: the mesh has no vertices"},
       {ply("element vertex 3\n" + xyz + usual, points), ":7: a second list of vertices"},
       {ply(usual + "element nothing 9\n", points + "3 0 1 2\n"),
        ":9: element \"nothing\" has no properties"}});
}

TEST(MeshFaults, ply_text) {
  check("a.ply",
        {{ply(usual, "0 0 0\n1 0\n0 1 0\n3 0 1 2\n"), ":11: three coordinates expected"},
         {ply(usual, "0 0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n"),
          ":11: the line has more numbers than the header declares for a vertex"},
         {ply(usual, "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
          ":11: the coordinate \"nan\" is not finite"},
         {ply(usual, "0 0 0\n1 0 a\n0 1 0\n3 0 1 2\n"), ":11: \"a\" is not a number"},
         {ply(usual, points + "3 0 1 3\n"), ":13: vertex index 3 is out of range (0 to 2)"},
         {ply(usual, points + "3 0 1 -2\n"), ":13: vertex index -2 is out of range (0 to 2)"},
         {ply(usual, points + "3 0 1\n"), ":13: the line ends where a vertex index is expected"},
         {ply(usual, points + "2 0 1\n"), ":13: no face or strip has more than two corners"},
         {ply(usual, points + "-3 0 1\n"), ":13: \"-3\" is not a number of list entries"},
         {ply(usual, "0.00000 0.00000 0.00000\n" + points.substr(6)),
          ":12: the file ends before face 1 of 1"},
         {ply(usual, points), ":7: the header declares 1 of \"face\", more than the file can hold"},
         {ply(usual, points + "3 0 1 2\n3 0 1 2\n"), ":14: data after the last declared element"}});
}

TEST(MeshFaults, ply_binary) {
  const std::string little = "binary_little_endian";
  const std::size_t start = ply(usual, "", little).size();
  const auto at = [&](std::size_t n) { return ": byte " + std::to_string(start + n) + ": "; };
  const auto vertices = [](float bad) {
    std::string out;
    for (const float x : {0.f, 0.f, 0.f, 1.f, bad, 0.f, 0.f, 1.f, 0.f}) out += test::raw(x);
    return out;
  };
  const auto face = [](char n, int a, int b, int c) {
    return std::string(1, n) + test::raw(a) + test::raw(b) + test::raw(c);
  };
  check("a.ply", {{ply(usual, vertices(0) + face(3, 0, 1, 2), little), "accepted"},
                  {ply(usual, vertices(NAN) + face(3, 0, 1, 2), little),
                   at(16) + "a coordinate of vertex 2 of 3 is not finite"},
                  {ply(usual, vertices(INFINITY) + face(3, 0, 1, 2), little),
                   at(16) + "a coordinate of vertex 2 of 3 is not finite"},
                  {ply(usual, vertices(0) + face(3, 0, 7, 2), little),
                   at(41) + "vertex index 7 in face 1 of 1 is out of range (0 to 2)"},
                  {ply(usual, vertices(0) + face(3, 0, 1, -1), little),
                   at(45) + "vertex index -1 in face 1 of 1 is out of range (0 to 2)"},
                  {ply(usual, vertices(0) + face(2, 0, 1, 2), little),
                   at(45) + "4 bytes more than the header declares"},
                  {ply(usual, vertices(0) + face(4, 0, 1, 2), little),
                   at(49) + "the file ends inside face 1 of 1"},
                  {ply(usual, vertices(0) + face(3, 0, 1, 2) + "\n", little), "accepted"}});
}

TEST(MeshFaults, stl_text) {
  const std::string open = "solid a\nfacet normal 0 0 1\nouter loop\n";
  const std::string v = "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  check("a.stl", {{"solid a\nendsolid a\n", ": the mesh has no triangles"},
                  {"solid a\n", ":1: the file ends before \"endsolid\""},
                  {"solid a\nface\n", ":2: \"facet\" or \"endsolid\" is expected, not \"face\""},
                  {"solid a\nfacet\n", ":2: \"facet normal\" and three numbers are expected"},
                  {"solid a\nfacet normal 0 0 1\nvertex 0 0 0\n",
                   ":3: \"outer\" is expected, not \"vertex\""},
                  {"solid a\nfacet normal 0 0 1\nouter\n", ":3: \"outer loop\" is expected"},
                  {open + "vertex 0 0\n", ":4: three coordinates expected"},
                  {open + "vertex 0 0 inf\n", ":4: the coordinate \"inf\" is not finite"},
                  {open + "vertex 0 0 x\n", ":4: \"x\" is not a number"},
                  {open + "vertex 0 0 0 0\n", ":4: unexpected \"0\""},
                  {open + "vertex 0 0 0\nvertex 1 0 0\nendloop\n",
                   ":6: \"vertex\" is expected, not \"endloop\""},
                  {open + v + "vertex 1 1 1\n", ":7: \"endloop\" is expected, not \"vertex\""},
                  {open + v + "endloop\n", ":7: \"endfacet\" is expected, but the file ends"},
                  {open + v + "endloop\nendfacet\nendsolid\nmore\n",
                   ":10: data outside of a solid: \"more\""}});
}

TEST(MeshFaults, stl_binary) {
  std::string good = test::as_binary_stl(test::tetrahedron(1));
  const auto with = [&](std::size_t at, const std::string& bytes) {
    return std::string(good).replace(at, bytes.size(), bytes);
  };
  const std::string nan = test::raw(std::numeric_limits<float>::quiet_NaN());
  check(
      "a.stl",
      {{good, "accepted"},
       {with(84, nan), "accepted"},  // a normal
       {with(84 + 50 + 12 + 16, nan), ": byte 162: a coordinate of triangle 2 of 4 is not finite"},
       {with(80, test::raw(5u)),
        ": byte 80: the header declares 5 triangles, that is 334 bytes, but the file has 284"},
       {with(80, test::raw(3u)),
        ": byte 80: the header declares 3 triangles, that is 234 bytes, but the file has 284"},
       {with(80, test::raw(0xffffffffu)),
        "accepted"},  // not known when it was written: the size tells
       {std::string(80, ' ') + test::raw(0u), ": the mesh has no triangles"},
       {"short", ": too short for an STL file (it begins with \"short\")"}});
  good.pop_back();
  EXPECT_EQ(said("a.stl", "solid" + good.substr(5)),
            ": byte 80: the header declares 4 triangles, that is 284 bytes, but the file has 283");
}

/// What is no STL at all is said to be none, before its bytes are taken for a count of triangles.
TEST(MeshFaults, a_file_of_another_kind_is_no_stl) {
  const std::string zip = std::string("PK\x03\x04") + std::string(300, '\x01');
  check("a.stl",
        {{zip, ": is not an STL file (it begins with \"PK\\x03\\x04\\x01\\x01\\x01\\x01…\")"},
         {"PK\x03\x04", ": is not an STL file (it begins with \"PK\\x03\\x04\")"},
         {"ISO-10303-21;\nHEADER;\n" + std::string(200, ' '),
          ": is not an STL file (it begins with \"ISO-1030…\")"},
         {"A letter to a friend, who wrote me a letter on how the weather is where letters come "
          "from, and so on for a while.",
          ": is not an STL file (it begins with \"A letter…\")"},
         {"<!DOCTYPE html>\n<html><body>Not found</body></html>\n",
          ": is not an STL file (it begins with \"<!DOCTYP…\")"},
         {"<html></html>", ": is not an STL file (it begins with \"<html></…\")"},
         {"{\"a\": 1}", ": is not an STL file (it begins with \"{\"a\": 1}\")"},
         {"x,y,z\n1,2,3\n", ": is not an STL file (it begins with \"x,y,z\\x0a1,…\")"},
         {"x;y;z\r1;2;3\r", ": is not an STL file (it begins with \"x;y;z\\x0d1;…\")"},
         // A line ends where a count would be: 0x0a202020 triangles are 8 GB.
         {std::string(80, 'a') + "   \nand more",
          ": is not an STL file (it begins with "
          "\"aaaaaaaa…\")"}});
}

// Reference: a thousand million vertices would take 24 GB, and minutes.
TEST(MeshFaults, hostile_counts_fail_at_once) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(said("a.off", "OFF\n1000000000 1 0\n0 0 0\n"),
            ":2: the header declares 1000000000 vertices and 1 faces, but only 6 bytes follow");
  EXPECT_EQ(said("a.off", "OFF\n1 9223372036854775807 0\n0 0 0\n"),
            ":2: the header declares 1 vertices and 9223372036854775807 faces, but only 6 bytes "
            "follow");
  EXPECT_EQ(said("a.ply", ply("element vertex 1000000000\n" + xyz + "element face 1\n" + corners,
                              points + "3 0 1 2\n")),
            ":3: the header declares 1000000000 of \"vertex\", more than the file can hold");
  EXPECT_EQ(
      said("a.ply", ply("element vertex 3\n" + xyz + "element face 9223372036854775807\n" + corners,
                        std::string(36, '0'), "binary_big_endian")),
      ":7: the header declares 9223372036854775807 of \"face\", more than the file can hold");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

/// A file of some megabytes of text, read in pieces; after the first, something is done to it.
std::string said_when(const TempFolder& folder,
                      const std::function<void(const std::filesystem::path&)>& happens) {
  std::string text = test::as_off(test::tetrahedron(1));
  const auto file = folder.write("a.off", text.append(9 << 20, '\n'));
  bool happened = false;
  try {
    const PolygonSoup soup = read_mesh(file, 1, [&](double fraction) {
      if (fraction > 0 && !std::exchange(happened, true)) happens(file);
      return true;
    });
    EXPECT_TRUE(happened);
    return std::to_string(soup.points.size()) + " points";
  } catch (const InputError& error) {
    return std::string(error.what()).substr(file.string().size());
  }
}

TEST(MeshFaults, a_file_that_is_cut_while_it_is_read_is_refused) {
  const TempFolder folder;
  EXPECT_EQ(
      said_when(folder, [](const auto& file) { std::filesystem::resize_file(file, 5 << 20); }),
      ": byte 4194304: cannot be read");
}

TEST(MeshFaults, of_a_file_that_is_replaced_while_it_is_read_the_old_one_counts) {
  const TempFolder folder;
  const auto other = folder.write("other", "no mesh at all");
  EXPECT_EQ(said_when(folder, [&](const auto& file) { std::filesystem::rename(other, file); }),
            "4 points");
}

TEST(MeshFaults, scaling_beyond_range) {
  const TempFolder folder;
  const auto file = folder.write("a.off", "OFF\n3 1 0\n0 0 0\n1e300 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_THROW(read_mesh(file, 1e10), InputError);
}

}  // namespace
}  // namespace sonde
