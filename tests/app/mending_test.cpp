// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/app_test.hpp"
#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A cube of 0.1 against meshes of other makes.
class Mending : public AppTest {
 protected:
  void SetUp() override {
    AppTest::SetUp();
    folder.write("probe.off", as_off(box({0.1, 0.1, 0.1})));
  }
  Outcome asked(const PolygonSoup& fixed, const std::vector<Vec3>& places,
                const std::string& flags = "") {
    folder.write("fixed.off", as_off(fixed));
    std::ostringstream poses;
    poses << "px,py,pz,qw,qx,qy,qz\n";
    for (const Vec3& p : places) poses << p.x() << ',' << p.y() << ',' << p.z() << ",1,0,0,0\n";
    folder.write("p.csv", poses.str());
    return expect_done("query --method pdt --probe probe.off --fixed fixed.off --poses p.csv " +
                       flags);
  }
  std::vector<double> depths(const PolygonSoup& fixed, const std::vector<Vec3>& places) {
    const Csv csv(asked(fixed, places).out);
    std::vector<double> out;
    for (std::size_t i = 0; i < places.size(); ++i) {
      out.push_back(csv.number(i, "depth"));
      if (csv.text(i, "status") == "penetrating") {
        EXPECT_LE(csv.number(i, "lower_bound"), out.back());
      }
    }
    return out;
  }
  /// A unit cube of one corner at that place.
  static PolygonSoup cube(const Vec3& corner, const Vec3& size = {1, 1, 1}) {
    return placed(box(size), corner + size / 2);
  }
};

// Reference: by hand, as the distance to the nearest face and half of the probe.
TEST_F(Mending, depths_in_what_looks_closed_are_those_of_a_solid) {
  const PolygonSoup whole = cube({0, 0, 0});
  const std::vector<Vec3> places{{0.5, 0.5, 0.5}, {0.9, 0.5, 0.5}, {0.98, 0.5, 0.5}};
  for (const PolygonSoup& broken :
       {cracked(whole, 1e-15, 1), cracked(whole, 1e-7, 2), cut_beyond(whole, Vec3::UnitX(), 0.9),
        cut_beyond(whole, Vec3(1, 1, 0), 0.7, 1e-8), joined(whole, whole),
        joined(whole, cube({0.2, 0.2, 0.2}, {0.7, 0.7, 0.7}))}) {
    const std::vector<double> found = depths(broken, places);
    EXPECT_NEAR(found[0], 0.55, 1e-4);
    EXPECT_NEAR(found[1], 0.15, 1e-4);
    EXPECT_NEAR(found[2], 0.07, 1e-4);
  }
}

TEST_F(Mending, parts_inside_out_are_solids_of_their_own) {
  const PolygonSoup mixed = joined(cube({0, 0, 0}), turned_over(cube({3, 0, 0}, {1, 1, 2})));
  const std::vector<double> found =
      depths(mixed, {{0.5, 0.5, 0.9}, {3.5, 0.5, 1.9}, {2, 0.5, 0.5}});
  EXPECT_NEAR(found[0], 0.15, 1e-4);
  EXPECT_NEAR(found[1], 0.15, 1e-4);
  EXPECT_EQ(found[2], 0);
  EXPECT_THAT(asked(mixed, {{0.5, 0.5, 0.9}}).err,
              HasSubstr("the fixed body fixed.off: 1 part of 2 inside out, turned\n"));
}

TEST_F(Mending, what_was_done_is_said_unless_quiet_and_can_be_refused) {
  const PolygonSoup open =
      without(icosphere(1, 3), [n = 0](const Vec3&) mutable { return ++n == 9; });
  const Outcome run = asked(open, {{0, 0, 0}});
  EXPECT_THAT(run.err, HasSubstr("1 opening closed by 1 triangle"));
  EXPECT_THAT(run.out, HasSubstr("penetrating"));
  EXPECT_EQ(asked(open, {{0, 0, 0}}, "--quiet").err, "");
  const Outcome refused = asked(open, {{0, 0, 0}}, "--repair none");
  EXPECT_THAT(refused.out, HasSubstr("separated"));
  EXPECT_THAT(refused.err, Not(HasSubstr("closed by")));
}

TEST_F(Mending, a_surface_that_could_be_a_solid_is_told_of_with_the_remedy) {
  const PolygonSoup open = without(icosphere(1, 3), [](const Vec3& x) { return x.z() > 0.8; });
  EXPECT_THAT(asked(open, {{0, 0, 0}}).err,
              AllOf(HasSubstr("taken as a surface"), HasSubstr("open mouth"),
                    HasSubstr("model solid closes it")));
  EXPECT_THAT(asked(open, {{0, 0, 0}}, "--fixed-model solid").out, HasSubstr("penetrating"));
}

/// A flat sheet in z = 0 about the origin, with a corner or the middle of a side of it, and the
/// square of the way there over the moment Î about the axis across that way.
struct FlatSheet {
  PolygonSoup mesh;
  Vec3 lowest;
  double lever;
};

// Reference: one contact at r on a plane, PD_g = d² / (1 + (r×n)ᵀ Î⁻¹ (r×n)), with the moments of a
// rectangle and a hexagon; a cube of 2 mm near the middle changes those by 10⁻⁵.
TEST_F(Mending, a_small_closed_part_does_not_take_the_mass_of_a_sheet) {
  const double tilt = 0.05, deep = 1e-4;
  const auto rectangle = [](double a, double b) {
    return PolygonSoup{
        {{-a / 2, -b / 2, 0}, {a / 2, -b / 2, 0}, {a / 2, b / 2, 0}, {-a / 2, b / 2, 0}},
        {{0, 1, 2, 3}}};
  };
  PolygonSoup hexagon{{}, {{}}};
  for (std::size_t k = 0; k < 6; ++k) {
    const double turn = two_pi * static_cast<double>(k) / 6;
    hexagon.points.emplace_back(std::cos(turn), std::sin(turn), 0);
    hexagon.polygons[0].push_back(k);
  }
  folder.write("floor.off", as_off(cube({-4, -4, -1}, {8, 8, 1})));
  for (const FlatSheet& sheet :
       {FlatSheet{rectangle(1, 1.5), {0.5, 0, 0}, 3}, FlatSheet{rectangle(1, 2), {0.5, 1, 0}, 6},
        FlatSheet{hexagon, {1, 0, 0}, 4.8}}) {
    const PolygonSoup speck = cube({-0.001, -0.001, 0.02}, {0.002, 0.002, 0.002});
    folder.write("sheet.off", as_off(joined(sheet.mesh, speck)));
    const Vec3 axis = Vec3(-sheet.lowest.y(), sheet.lowest.x(), 0).normalized();
    const Quat q(Eigen::AngleAxisd(tilt, axis));
    std::ostringstream pose;
    pose.precision(17);
    pose << "px,py,pz,qw,qx,qy,qz\n0,0," << -(q * sheet.lowest).z() - deep << ',' << q.w() << ','
         << q.x() << ',' << q.y() << ',' << q.z() << '\n';
    folder.write("p.csv", pose.str());
    const Outcome run = expect_done("query --probe sheet.off --fixed floor.off --poses p.csv");
    const double c = std::cos(tilt), depth = deep / std::sqrt(1 + c * c * sheet.lever);
    EXPECT_NEAR(Csv(run.out).number(0, "depth"), depth, 1e-3 * depth);
    EXPECT_THAT(run.err, AllOf(HasSubstr("1 of 2 parts stays open: only its triangles count"),
                               HasSubstr("the probe has its mass by area: 100 % of the area")));
    EXPECT_THAT(expect_done("info sheet.off").out,
                HasSubstr("  mass            by area: 100 % of the area belongs to open parts\n"));
    const json mesh = json::parse(expect_done("info --json sheet.off").out).at("meshes").at(0);
    EXPECT_EQ(mesh.at("mass_why"), "by area: 100 % of the area belongs to open parts");
    EXPECT_TRUE(mesh.contains("area"));
  }
}

TEST_F(Mending, info_lists_it_as_text_and_json) {
  folder.write("fixed.off", as_off(joined(cube({0, 0, 0}), turned_over(cube({3, 0, 0})))));
  EXPECT_THAT(expect_done("info fixed.off").out,
              AllOf(HasSubstr("mended          1 part of 2 inside out, turned\n"),
                    HasSubstr("volume V        2 m³\n")));
  const json mesh = json::parse(expect_done("info --json fixed.off").out).at("meshes").at(0);
  EXPECT_EQ(mesh.at("repairs").at("turned_parts"), 1);
  EXPECT_EQ(mesh.at("repairs").at("parts"), 2);
  EXPECT_NEAR(mesh.at("center_of_mass").at(0).get<double>(), 2, 1e-12);
}

TEST_F(Mending, the_head_of_json_results_has_it) {
  const PolygonSoup mixed = joined(cube({0, 0, 0}), turned_over(cube({3, 0, 0})));
  const json results = json::parse(asked(mixed, {{0.5, 0.5, 0.5}}, "--json").out);
  EXPECT_EQ(results.at("remarks").at(0),
            "the fixed body fixed.off: 1 part of 2 inside out, turned");
  EXPECT_EQ(results.at("results").size(), 1u);
  const json clean = json::parse(asked(cube({0, 0, 0}), {{0.5, 0.5, 0.5}}, "--json").out);
  EXPECT_FALSE(clean.contains("remarks"));
}

TEST_F(Mending, a_scene_keeps_it) {
  folder.write("fixed.off",
               as_off(without(icosphere(1, 3), [n = 0](const Vec3&) mutable { return ++n == 9; })));
  folder.write("p.csv", "px,py,pz,qw,qx,qy,qz\n0,0,0,1,0,0,0\n");
  for (const char* repair : {"auto", "none"}) {
    folder.write("s.sonde.json",
                 std::string(R"({"probe": {"mesh": "probe.off"}, "fixed": {"mesh":)") +
                     R"( "fixed.off", "repair": ")" + repair + "\"}}");
    EXPECT_THAT(expect_done("query s.sonde.json --poses p.csv").out,
                HasSubstr(std::string(repair) == "auto" ? "penetrating" : "separated"));
  }
  folder.write(
      "s.sonde.json",
      R"({"probe": {"mesh": "probe.off"}, "fixed": {"mesh": "fixed.off", "repair": "aut"}})");
  expect_refused("query s.sonde.json --poses p.csv", 3, "\"auto\"");
}

}  // namespace
}  // namespace sonde::test
