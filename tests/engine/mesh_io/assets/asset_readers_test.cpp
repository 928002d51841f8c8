// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is a soup whose copies are placed by Eigen's transforms, and read from OFF: each
// polygon lies where it should, in single precision, and faces the same way.
#include "engine/mesh_io/assets/asset_readers.hpp"

#include <gtest/gtest.h>
#include <locale.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <stdexcept>

#include "engine/geometry/mass.hpp"
#include "engine/geometry/mass_integrals.hpp"
#include "engine/mesh_io/assets/packed_soup.hpp"
#include "engine/platform/child_process.hpp"
#include "tests/engine/mesh_io/assets/asset_files.hpp"
#include "tests/engine/mesh_io/mesh_checks.hpp"
#include "tests/support/locales.hpp"

namespace sonde {
namespace {

using Affine = Eigen::Affine3d;
using nlohmann::json;

PolygonSoup in_triangles(const PolygonSoup& convex) {
  PolygonSoup out{convex.points, {}};
  for (const Polygon& p : convex.polygons)
    for (std::size_t k = 2; k < p.size(); ++k) out.polygons.push_back({p[0], p[k - 1], p[k]});
  return out;
}

/// Copies of a soup; what a mirror turns inside out is turned back.
PolygonSoup placed(const PolygonSoup& soup, const std::vector<Affine>& copies) {
  PolygonSoup out;
  for (const Affine& copy : copies) {
    const std::size_t before = out.points.size();
    for (const Vec3& x : soup.points) out.points.push_back(copy * x);
    for (Polygon p : soup.polygons) {
      for (std::size_t& i : p) i += before;
      if (copy.linear().determinant() < 0) std::ranges::reverse(p);
      out.polygons.push_back(std::move(p));
    }
  }
  return out;
}

struct Facet {
  Vec3 centre = Vec3::Zero(), area = Vec3::Zero();
};
Facet facet_of(const PolygonSoup& soup, const Polygon& p) {
  Facet out;
  for (std::size_t k = 0; k < p.size(); ++k) {
    out.centre += soup.points[p[k]] / static_cast<double>(p.size());
    out.area += (soup.points[p[k]] - soup.points[p[0]])
                    .cross(soup.points[p[(k + 1) % p.size()]] - soup.points[p[0]]) /
                2;
  }
  return out;
}

void expect_same_place(const PolygonSoup& got, const PolygonSoup& want) {
  ASSERT_EQ(got.polygons.size(), want.polygons.size());
  double size = 0;
  for (const Vec3& x : want.points) size = std::max(size, x.cwiseAbs().maxCoeff());
  for (std::size_t k = 0; k < got.polygons.size(); ++k) {
    const Facet a = facet_of(got, got.polygons[k]), b = facet_of(want, want.polygons[k]);
    ASSERT_EQ(got.polygons[k].size(), want.polygons[k].size());
    EXPECT_LT((a.centre - b.centre).norm(), 1e-6 * size) << k;
    EXPECT_LT((a.area - b.area).norm(), 1e-6 * size * size) << k;
  }
}

json matrix_of(const Affine& copy) {
  json out = json::array();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) out.push_back(copy.matrix()(r, c));
  return out;
}

Affine turned(double angle, const Vec3& axis, const Vec3& by, const Vec3& scale) {
  Affine out = Affine::Identity();
  out.translate(by).rotate(Eigen::AngleAxisd(angle, axis.normalized())).scale(scale);
  return out;
}

const Affine as_it_is = Affine::Identity();
const Affine mirrored = turned(0.7, {1, 2, -1}, {0.3, -0.2, 0.1}, {-1, 1, 1});
const Affine stretched = turned(-1.9, {0, 1, 3}, {-0.4, 0.5, 0}, {0.5, 2, 1.25});

/// Shapes that fit into 16-bit indices, of several sizes.
std::vector<PolygonSoup> shapes() {
  return {in_triangles(test::box({0.02, 0.03, 0.05})), in_triangles(test::sphere(0.4, 9, 14)),
          in_triangles(test::torus(0.1, 0.03, 17, 8))};
}

TEST(Gltf, copies_are_placed_and_mirrored) {
  for (const PolygonSoup& shape : shapes()) {
    const json nodes = {{{"mesh", 0}, {"children", {1}}, {"matrix", matrix_of(stretched)}},
                        {{"mesh", 0}, {"matrix", matrix_of(mirrored)}},
                        {{"mesh", 0}}};
    const test::GltfFile file = test::gltf_of(shape, nodes, {0, 2});
    const PolygonSoup want = placed(shape, {stretched, stretched * mirrored, as_it_is});
    expect_same_place(test::read_bytes_as("a.glb", test::as_glb(file)), want);
    expect_same_place(test::read_bytes_as("a.gltf", test::as_gltf(file)), want);
    test::GltfFile inside = file;
    inside.tree = nlohmann::json::parse(test::as_gltf(file));
    inside.data.clear();
    expect_same_place(test::read_bytes_as("a.glb", test::as_glb(inside)), want);
  }
}

/// Translation, rotation and scale apart, as most programs write them.
TEST(Gltf, parts_of_a_placement) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.1, Vec3(2, -1, 1).normalized()));
  const json node = {{"mesh", 0},
                     {"translation", {0.1, 0.2, -0.3}},
                     {"rotation", {turn.x(), turn.y(), turn.z(), turn.w()}},
                     {"scale", {1.5, -0.5, 2}}};
  Affine copy = Affine::Identity();
  copy.translate(Vec3(0.1, 0.2, -0.3)).rotate(turn).scale(Vec3(1.5, -0.5, 2));
  const PolygonSoup shape = shapes()[1];
  expect_same_place(
      test::read_bytes_as("a.glb", test::as_glb(test::gltf_of(shape, json::array({node}), {0}))),
      placed(shape, {copy}));
}

/// A tetrahedron as a strip and as triangles: the volume, by the divergence theorem, is the same.
TEST(Gltf, strips) {
  const PolygonSoup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                {{0, 2, 1}, {0, 2, 1}}};
  test::GltfFile file = test::gltf_of(tetrahedron, {{{"mesh", 0}}}, {0});
  // The strip 0 2 1 3 0 2: 021, 123 turned, 130, 302 turned.
  const std::uint16_t strip[] = {0, 2, 1, 3, 0, 2};
  for (std::size_t k = 0; k < 6; ++k) file.data.replace(48 + 2 * k, 2, test::raw(strip[k]));
  file.tree["meshes"][0]["primitives"][0]["mode"] = 5;
  const PolygonSoup got = test::read_bytes_as("a.glb", test::as_glb(file));
  ASSERT_EQ(got.polygons.size(), 4u);
  EXPECT_NEAR(mass_by_volume(triangulate(got).soup).measure, 1. / 6, 1e-7);
}

TEST(Gltf, what_is_no_shape_is_left_out_and_said) {
  const PolygonSoup shape = shapes()[0];
  test::GltfFile file = test::gltf_of(shape, {{{"mesh", 0}, {"skin", 0}}}, {0});
  file.tree["skins"] = {{{"joints", {0}}}};
  file.tree["materials"] = {{{"normalTexture", {{"index", 7}}}}};
  file.tree["images"] = {{{"uri", "elsewhere.png"}}};
  file.tree["animations"] = json::array({5});
  file.tree["scenes"].push_back({{"nodes", json::array()}});
  json& primitives = file.tree["meshes"][0]["primitives"];
  primitives[0]["material"] = 3;
  primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});  // points
  const PolygonSoup got = test::read_bytes_as("a.glb", test::as_glb(file));
  expect_same_place(got, shape);
  EXPECT_EQ(got.remarks,
            (std::vector<std::string>{"1 skin not applied: meshes are as they were bound",
                                      "1 set of points or lines left out: they bound nothing",
                                      "scene 1 of 2 is read"}));
}

std::string transform_3mf(const Affine& copy) {
  auto out = test::exact_stream();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r) out << (c + r > 0 ? " " : "") << copy.matrix()(r, c);
  return " transform=\"" + out.str() + "\"";
}

TEST(ThreeMf, items_and_components_in_the_unit_of_the_file) {
  for (const PolygonSoup& shape : shapes()) {
    const std::string resources =
        test::object_3mf(shape, "4") + "<object id=\"9\"><components><component objectid=\"4\"" +
        transform_3mf(mirrored) + "/><component objectid=\"4\"/></components></object>";
    const std::string build =
        "<item objectid=\"9\"" + transform_3mf(stretched) + "/><item objectid=\"4\"/>";
    const std::pair<const char*, double> units[] = {{"", 1e-3},
                                                    {"unit=\"micron\"", 1e-6},
                                                    {"unit=\"millimeter\"", 1e-3},
                                                    {"unit=\"centimeter\"", 1e-2},
                                                    {"unit=\"inch\"", 0.0254},
                                                    {"unit=\"foot\"", 0.3048},
                                                    {"unit=\"meter\"", 1}};
    for (const auto& [unit, metres] : units) {
      const std::string text = test::xml_3mf(unit, resources, build);
      PolygonSoup want = placed(shape, {stretched * mirrored, stretched, as_it_is});
      for (Vec3& x : want.points) x *= metres;
      expect_same_place(test::read_bytes_as("a.3mf", test::as_3mf(text)), want);
      expect_same_place(test::read_bytes_as("a.3MF", test::as_3mf(text, false)), want);
    }
  }
}

TEST(Dae, nodes_and_instances_in_the_unit_of_the_file) {
  const PolygonSoup quads = test::box({0.2, 0.3, 0.5});
  const std::string nodes =
      "<node id=\"n\"><translate>0.1 0.2 0.3</translate><rotate>0 0 1 90</rotate><scale>-1 1 "
      "2</scale><instance_geometry url=\"#g\"/><node><translate>0 1 0</translate>"
      "<instance_geometry url=\"#g\"/></node></node><node><translate>-3 0 0</translate>"
      "<instance_node url=\"#n\"/></node>";
  Affine outer = Affine::Identity();
  outer.translate(Vec3(0.1, 0.2, 0.3))
      .rotate(Eigen::AngleAxisd(std::acos(0.), Vec3::UnitZ()))
      .scale(Vec3(-1, 1, 2));
  const Affine inner = outer * Eigen::Translation3d(0, 1, 0);
  const Affine away = Affine(Eigen::Translation3d(-3, 0, 0));
  for (const auto& [unit, metres] : {std::pair{"", 1.},
                                     {"<unit name=\"inch\" meter=\"0.0254\"/>", 0.0254},
                                     {"<unit meter=\"0.001\"/>", 0.001}})
    // Which axis is up is the user's to say, as for the other formats.
    for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
      PolygonSoup want = placed(quads, {outer, inner, away * outer, away * inner});
      for (Vec3& x : want.points) x *= metres;
      expect_same_place(test::read_bytes_as("a.dae", test::as_dae(quads, unit, up, nodes)), want);
    }
}

TEST(Assets, a_scale_comes_on_top_of_the_unit) {
  const PolygonSoup shape = shapes()[0];
  const test::TempFolder folder;
  const auto file = folder.write(
      "a.3mf", test::as_3mf(test::xml_3mf("unit=\"inch\"", test::object_3mf(shape, "1"),
                                          "<item objectid=\"1\"/>")));
  PolygonSoup want = shape;
  for (Vec3& x : want.points) x *= 3 * 0.0254;
  expect_same_place(read_mesh(file, 3), want);
}

/// A file read where decimals have a comma: in another process, whose locale is its own.
PolygonSoup read_in_german(const std::filesystem::path& locales, const std::string& name,
                           const std::string& bytes) {
  const ChildEnd end = in_child_process(
      [&] {
        ::setenv("LOCPATH", locales.c_str(), 1);
        const locale_t german = ::newlocale(LC_ALL_MASK, "de_DE.UTF-8", nullptr);
        if (!german || ::uselocale(german) == nullptr) throw std::runtime_error("no such locale");
        return packed(test::read_bytes_as(name, bytes));
      },
      {});
  EXPECT_FALSE(end.threw);
  return unpacked(name, end.output);
}

TEST(Assets, numbers_have_a_point_in_any_locale) {
  const test::TempFolder folder;
  const auto locales = test::make_locale(folder, "de_DE");
  PolygonSoup want = shapes()[0];
  const std::string threemf = test::as_3mf(
      test::xml_3mf("unit=\"meter\"", test::object_3mf(want, "1"), "<item objectid=\"1\"/>"));
  expect_same_place(read_in_german(locales, "a.3mf", threemf), want);
  const std::string dae =
      test::as_dae(want, "<unit meter=\"0.5\"/>", "Z_UP",
                   "<node><scale>0.5 0.5 0.5</scale><instance_geometry url=\"#g\"/></node>");
  for (Vec3& x : want.points) x *= 0.25;
  expect_same_place(read_in_german(locales, "a.dae", dae), want);
}

TEST(Assets, a_reader_is_cancelled) {
  const PolygonSoup shape = shapes()[1];
  const std::string files[] = {
      test::as_glb(test::gltf_of(shape, {{{"mesh", 0}}}, {0})),
      test::as_3mf(test::xml_3mf("", test::object_3mf(shape, "1"), "<item objectid=\"1\"/>")),
      test::as_dae(shape, "", "Z_UP", "<node><instance_geometry url=\"#g\"/></node>")};
  const auto no = [](double) { return false; };
  EXPECT_THROW(read_gltf("a", files[0], no), Cancelled);
  EXPECT_THROW(read_3mf("a", files[1], no), Cancelled);
  EXPECT_THROW(read_dae("a", files[2], no), Cancelled);
}

}  // namespace
}  // namespace sonde
