// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/read_mesh.hpp"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <locale>

#include "engine/body/body.hpp"
#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/real_meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

using test::TempFolder;

void expect_same(const PolygonSoup& got, const PolygonSoup& want) {
  EXPECT_EQ(got.polygons, want.polygons);
  ASSERT_EQ(got.points.size(), want.points.size());
  for (std::size_t i = 0; i < want.points.size(); ++i) EXPECT_EQ(got.points[i], want.points[i]);
}

/// Triangle by triangle, as STL does not keep which corners are one vertex.
void expect_same_triangles(const PolygonSoup& got, const PolygonSoup& want) {
  ASSERT_EQ(got.polygons.size(), want.polygons.size());
  for (std::size_t i = 0; i < want.polygons.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(got.points[got.polygons[i][k]], want.points[want.polygons[i][k]]);
}

/// Triangles and quads, coordinates that take all 17 digits, and some that are not round.
PolygonSoup mixed_mesh() {
  PolygonSoup soup = test::box({1.0 / 3, 2e-7, 1e10 / 7});
  soup.polygons.push_back({0, 1, 2});
  soup.polygons.push_back({0, 1, 3, 2, 6, 4});
  return soup;
}

/// A mesh of triangles whose coordinates fit into single precision.
PolygonSoup single_precision_mesh() {
  PolygonSoup soup = test::torus(1, 0.3, 9, 7);
  for (Vec3& x : soup.points)
    for (double& c : x) {
      const volatile float rounded = static_cast<float>(c);  // g++ 12 drops it without volatile
      c = rounded;
    }
  return soup;
}

class AnyFormat : public testing::TestWithParam<const char*> {
 protected:
  std::string contents(const PolygonSoup& soup) const {
    const std::string kind = GetParam();
    if (kind == "off") return test::as_off(soup);
    if (kind == "binary off") return test::as_binary_off(soup);
    if (kind == "obj") return test::as_obj(soup);
    if (kind == "text ply") return test::as_text_ply(soup);
    if (kind == "little ply") return test::as_binary_ply(soup, false);
    if (kind == "big ply") return test::as_binary_ply(soup, true);
    if (kind == "text stl") return test::as_text_stl(soup);
    return test::as_binary_stl(soup, "solid, but binary all the same");
  }
  std::string name() const {
    const std::string kind = GetParam();
    return "mesh." + kind.substr(kind.size() - 3);
  }
  bool is_stl() const { return name() == "mesh.stl"; }
  TempFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(ReadMesh, AnyFormat,
                         testing::Values("off", "binary off", "obj", "text ply", "little ply",
                                         "big ply", "text stl", "binary stl"));

TEST_P(AnyFormat, reads_back_what_was_written) {
  const PolygonSoup mesh = single_precision_mesh();
  const PolygonSoup got = read_mesh(folder_.write(name(), contents(mesh)));
  expect_same_triangles(got, mesh);
  EXPECT_EQ(got.points.size(), mesh.points.size());  // corners of STL become vertices again
  if (is_stl()) return;
  expect_same(got, mesh);
  if (GetParam() == std::string("binary off")) return;  // it holds single precision
  expect_same(read_mesh(folder_.write(name(), contents(mixed_mesh()))), mixed_mesh());
}

TEST_P(AnyFormat, scales) {
  PolygonSoup mesh = single_precision_mesh();
  const auto file = folder_.write(name(), contents(mesh));
  for (Vec3& x : mesh.points) x *= 0.001;
  expect_same_triangles(read_mesh(file, 0.001), mesh);
}

TEST_P(AnyFormat, extension_in_upper_case) {
  std::string upper = name();
  for (char& c : upper) c = static_cast<char>(std::toupper(c));
  EXPECT_EQ(read_mesh(folder_.write(upper, contents(single_precision_mesh()))).polygons.size(),
            126u);
}

TEST_P(AnyFormat, reports_progress_and_can_be_cancelled_at_any_point) {
  const PolygonSoup mesh = test::torus(1, 0.3, 200, 100);
  const auto file = folder_.write(name(), contents(mesh));
  std::vector<double> seen;
  read_mesh(file, 1, [&](double f) {
    seen.push_back(f);
    return true;
  });
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_GE(seen.size(), 3u);
  EXPECT_GE(seen.front(), 0);
  EXPECT_EQ(seen.back(), 1);
  for (std::size_t stop = 0; stop < seen.size(); ++stop) {
    std::size_t calls = 0;
    EXPECT_THROW(read_mesh(file, 1, [&](double) { return calls++ < stop; }), Cancelled) << stop;
    EXPECT_EQ(calls, stop + 1);
  }
}

struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST_P(AnyFormat, numbers_have_a_point_whatever_the_locale) {
  const PolygonSoup mesh = single_precision_mesh();
  const auto file = folder_.write(name(), contents(mesh));
  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Commas));
  const std::string old_c = std::setlocale(LC_NUMERIC, nullptr);
  for (const char* german : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"})  // where it is installed
    if (std::setlocale(LC_NUMERIC, german)) break;
  PolygonSoup got;
  EXPECT_NO_THROW(got = read_mesh(file));
  const bool kept = std::use_facet<std::numpunct<char>>(std::locale()).decimal_point() == ',';
  std::locale::global(old);
  std::setlocale(LC_NUMERIC, old_c.c_str());
  EXPECT_TRUE(kept) << "the program's locale was not put back";
  expect_same_triangles(got, mesh);
}

TEST_P(AnyFormat, every_truncation_is_refused_or_told) {
  const PolygonSoup mesh = test::tetrahedron(1);
  std::string whole = contents(mesh);
  while (whole.back() == '\n') whole.pop_back();
  // Cut inside the last line a text may still be whole: "3 0 1 12" without its 2, a name without
  // its end. OBJ declares nothing: cut between lines it is a mesh of fewer faces.
  const bool text = std::string(GetParam()).find(' ') == std::string::npos ||
                    std::string(GetParam()).starts_with("text");
  std::size_t last = text ? whole.rfind('\n') + 1 : whole.size();
  if (name() == "mesh.obj") last = whole.find("f ");
  // A text STL declares nothing either: cut between triangles it may be all there is, and is told.
  const auto told = [](const PolygonSoup& soup) { return soup.remarks.size() == 1; };
  for (std::size_t size = 0; size < last; ++size) {
    const auto file = folder_.write(name(), whole.substr(0, size));
    const bool between = std::string(GetParam()) == "text stl" &&
                         whole.substr(0, size).find("endfacet") != std::string::npos &&
                         whole.find("facet", whole.rfind("endfacet", size)) != std::string::npos;
    try {
      const PolygonSoup soup = read_mesh(file);
      EXPECT_TRUE(between && told(soup)) << size;
    } catch (const InputError&) {
    }
  }
}

TEST_P(AnyFormat, more_data_than_declared_is_refused_or_told) {
  const std::string whole = contents(test::tetrahedron(1));
  for (const std::string& more : {std::string("1 2 3\n"), std::string(50, 'x')}) try {
      // What is read all the same says so.
      EXPECT_FALSE(read_mesh(folder_.write(name(), whole + more)).remarks.empty()) << more;
    } catch (const InputError&) {
    }
}

TEST_P(AnyFormat, random_damage_never_crashes) {
  std::mt19937_64 random(7);
  const std::string whole = contents(test::tetrahedron(1));
  for (int i = 0; i < 2000; ++i) {
    std::string bytes = whole;
    for (int k = 0; k <= i % 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    try {
      const PolygonSoup soup = read_mesh(folder_.write(name(), bytes));
      for (const auto& polygon : soup.polygons)
        for (const std::size_t v : polygon) ASSERT_LT(v, soup.points.size());
      for (const Vec3& x : soup.points) ASSERT_TRUE(x.allFinite());
    } catch (const InputError&) {  // is what most damage should give
    }
  }
}

TEST_P(AnyFormat, carriage_returns_and_byte_order_mark) {
  const std::string kind = GetParam();
  if (kind.starts_with("binary") || kind == "little ply" || kind == "big ply") return;
  const PolygonSoup mesh = single_precision_mesh();
  std::string text = "\xef\xbb\xbf";
  for (const char c : contents(mesh)) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_same_triangles(read_mesh(folder_.write(name(), text)), mesh);
}

// ------------------------------------------------------------------------ what files have in them

PolygonSoup read_text(const std::string& name, const std::string& text) {
  const TempFolder folder;
  return read_mesh(folder.write(name, text));
}

PolygonSoup one_triangle() { return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}}; }

TEST(ReadOff, comments_blank_lines_colours_and_normals) {
  const std::vector<std::string> texts = {
      "# first\n\nOFF # keyword\n# counts\n3 1 3\n\n0 0 0 # a\n 1 0 0\n+0 1 .5\n# faces\n3 0 1 "
      "2\n# end\n",
      "OFF 3 1\n0 0 0\n1 0 0\n0 1 5e-1\n3 0 1 2",
      "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0.5 0 255 0 255\n3 0 1 2\n",
      "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0.5 0 0 1\n3 0 1 2\n",
      "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2 0.5 0.5 0.5 1\n"};
  for (const std::string& text : texts) expect_same(read_text("a.off", text), one_triangle());
}

TEST(ReadOff, binary_vertices_may_have_texture_colour_and_normal) {
  const PolygonSoup mesh = single_precision_mesh();
  const TempFolder folder;
  expect_same(read_mesh(folder.write("a.off", test::as_binary_off(mesh, "STCN", 9))), mesh);
  expect_same(read_mesh(folder.write("b.off", test::as_binary_off(mesh, "C", 4))), mesh);
}

TEST(ReadObj, statements_that_are_no_mesh_are_passed_over) {
  expect_same(
      read_text("a.obj",
                "# c:\\\nmtllib a.mtl\no thing\ng group\nv 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0.5 1.0\n"
                "vt 0 0\nvn 0 0 1\nvp 0\nusemtl red\ns off\nl 1 2\np 1\nf 1/1/1 2//1 3/1\n"),
      one_triangle());
}

TEST(ReadObj, negative_indices_count_back_and_forward_ones_are_allowed) {
  expect_same(read_text("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf -3 -2 -1\nv 9 9 9\n"),
              {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}, {9, 9, 9}}, {{0, 1, 2}}});
  expect_same(read_text("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0.5\n"), one_triangle());
}

TEST(ReadObj, a_backslash_joins_lines) {
  expect_same(read_text("a.obj", "v 0 0 0\nv 1 \\\n 0 0\nv 0 1 0.5\nf 1 \\\r\n2 \\\n3\n"),
              one_triangle());
}

TEST(ReadPly, unknown_elements_and_properties_are_passed_over) {
  expect_same(
      read_text("a.ply",
                "ply\r\nformat ascii 1.0\nobj_info x\nelement camera 1\nproperty float fov\n"
                "property list uchar float more\nelement vertex 3\nproperty uchar red\n"
                "property float x\nproperty float32 y\nproperty float64 z\nproperty float nx\n"
                "element face 1\nproperty uchar red\nproperty list uint8 ushort vertex_index\n"
                "element halfedge 1\nproperty int source\nproperty int target\nend_header\n"
                "0.5 2 1 nan\n255 0 0 0 nan\n255 1 0 0 0\n1 0 1 0.5 0\n7 3 0 1 2\n4 5\n"),
      one_triangle());
}

TEST(ReadPly, unknown_elements_in_binary) {
  std::string bytes =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty uchar r\n"
      "property float y\nproperty float z\nelement edge 2\nproperty list uchar ushort of\n"
      "element face 1\nproperty list uchar uint vertex_indices\nproperty double "
      "quality\nend_header\n";
  for (const Vec3& x : one_triangle().points)
    bytes += test::raw(static_cast<float>(x.x())) + "r" + test::raw(static_cast<float>(x.y())) +
             test::raw(static_cast<float>(x.z()));
  bytes += "\x01" + test::raw(std::uint16_t{9}) + std::string(1, '\0');
  bytes += "\x03" + test::raw(0u) + test::raw(1u) + test::raw(2u) + test::raw(1.5);
  expect_same(read_text("a.ply", bytes), one_triangle());
}

TEST(ReadStl, several_solids_odd_case_and_normals_that_are_no_numbers) {
  const std::string facet =
      "FACET Normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0.5\nendloop\n"
      "endfacet\n";
  const PolygonSoup got =
      read_text("a.stl", "Solid one\n" + facet + "endsolid one\n\nsolid\n" + facet + "endsolid\n");
  EXPECT_EQ(got.polygons, (std::vector<std::vector<std::size_t>>{{0, 1, 2}, {0, 1, 2}}));
}

TEST(ReadMesh, a_name_is_a_meshs_by_its_extension_in_any_case) {
  for (const char* name :
       {"a.off", "M3.5.STL", "b.c/d.Ply", "a.obj", "a.glb", "a.gltf", "a.3mf", "a.dae"})
    EXPECT_TRUE(is_mesh_name(name)) << name;
  for (const char* name : {"M3.5 screw", "stl", ".stl", "a.stl.gz", "a.json", ""})
    EXPECT_FALSE(is_mesh_name(name)) << name;
}

TEST(ReadMesh, tiny_numbers_are_zero_enough) {
  const std::string none = "0." + std::string(400, '0') + "1";
  for (const std::string& small : {std::string("1e-400"), std::string("-1E-400"), none})
    EXPECT_NO_THROW(read_text("a.off", "OFF\n3 1 0\n0 " + small + " 0\n1 0 0\n0 1 0.5\n3 0 1 2\n"))
        << small;
}

// ------------------------------------------------------------------------------------ real meshes

// b9.ply is a cloud of points, prim.off has more faces than it declares: both must be refused.
TEST(RealMeshes, all_are_read_or_refused_for_a_reason) {
  std::vector<std::string> refused;
  for (const auto& file : test::real_meshes()) {
    try {
      const auto body = load_body(file.string(), Model::automatic);
      EXPECT_TRUE(body->mass.measure > 0 && body->mass.inertia[2] > 0) << file;
    } catch (const InputError&) {
      refused.push_back(file.filename().string());
    }
  }
  EXPECT_EQ(refused, (std::vector<std::string>{"b9.ply", "prim.off"}));
}

// Reference: CGAL's readers, on files that they read; the rest of them hold what CGAL stumbles on
// (binary formats told by their first bytes, comments, colours).
TEST(RealMeshes, are_what_cgal_reads) {
  int compared = 0;
  for (const auto& file : test::real_meshes()) {
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    PolygonSoup want;
    if (!CGAL::IO::read_polygon_soup(file.string(), points, want.polygons) || points.empty())
      continue;
    for (const auto& p : points) want.points.emplace_back(p.x(), p.y(), p.z());
    try {
      expect_same(read_mesh(file), want);
      ++compared;
    } catch (const InputError&) {  // AllAreReadOrRefusedForAReason knows which
    }
  }
  EXPECT_GE(compared, 40);
}

// Reference: counts from the headers of the files; V of the unit cube and of the other formats of
// one sphere.
TEST(RealMeshes, are_what_they_are_known_to_be) {
  const auto load = [](const char* name) {
    return load_body(test::real_mesh(name).string(), Model::automatic);
  };
  EXPECT_EQ(load("armadillo.off")->soup.triangles.size(), 52000u);
  EXPECT_TRUE(load("camel.off")->solid);
  EXPECT_TRUE(load("elephant-with-holes.off")->solid);
  EXPECT_EQ(load("elephant-with-holes.off")->repairs.caps, 171u);
  EXPECT_FALSE(load("head.off")->solid);
  EXPECT_NEAR(load("cube.off")->mass.measure, 8, 1e-12);
  EXPECT_TRUE(load("tetrahedron.off")->turned);
  EXPECT_EQ(load("degtri_sliding.off")->degenerate, 4u);
  const double volume = load("sphere.off")->mass.measure;
  EXPECT_NEAR(load("sphere.ply")->mass.measure, volume, 1e-5 * volume);
  EXPECT_NEAR(load("sphere.stl")->mass.measure, volume, 1e-5 * volume);
}

}  // namespace
}  // namespace sonde
