// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCubeSource.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/ui/export/made_up_instant.hpp"
#include "ui/base/theme.hpp"
#include "ui/export/vtk_scene.hpp"

namespace sonde::ui::test {
namespace {

using nlohmann::json;
using sonde::test::TempFolder;

vtkSmartPointer<vtkPolyData> triangle_cube(double side) {
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(side);
  cube->SetYLength(side);
  cube->SetZLength(side);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

class GltfTest : public testing::Test {
 protected:
  json written(const ExportedInstant& instant) {
    write_gltf(folder / "scene.gltf", surfaces, instant);
    return json::parse(sonde::test::text_of(folder / "scene.gltf"));
  }
  /// The colour of a mesh, with its opacity.
  static std::vector<double> colour_of(const json& root, std::size_t mesh) {
    const auto& part = root.at("meshes").at(mesh).at("primitives").at(0);
    const auto& material = root.at("materials").at(part.at("material").get<std::size_t>());
    return material.at("pbrMetallicRoughness").at("baseColorFactor").get<std::vector<double>>();
  }
  static bool is(const std::vector<double>& colour, const QColor& wanted) {
    return std::abs(colour.at(0) - wanted.redF()) < 0.01 &&
           std::abs(colour.at(1) - wanted.greenF()) < 0.01 &&
           std::abs(colour.at(2) - wanted.blueF()) < 0.01;
  }
  /// The middle of a mesh by the bounds that the file states.
  static Vec3 middle_of(const json& root, std::size_t mesh) {
    const auto& attributes = root.at("meshes").at(mesh).at("primitives").at(0).at("attributes");
    const auto& positions = root.at("accessors").at(attributes.at("POSITION").get<std::size_t>());
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i)
      out[Eigen::Index(i)] =
          (positions.at("min").at(i).get<double>() + positions.at("max").at(i).get<double>()) / 2;
    return out;
  }
  TempFolder folder;
  const Surfaces surfaces{triangle_cube(0.02), triangle_cube(0.1), Vec3::Zero()};
};

TEST_F(GltfTest, a_held_probe_has_its_ghost_an_arrow_for_each_contact_and_one_for_the_force) {
  const ExportedInstant instant = made_up_instant();
  const json root = written(instant);
  EXPECT_EQ(root.at("asset").at("version"), "2.0");
  ASSERT_EQ(root.at("meshes").size(), 3u + 2u + 1u);
  EXPECT_TRUE(is(colour_of(root, 0), colour::fixed));
  EXPECT_TRUE(is(colour_of(root, 1), colour::probe));
  EXPECT_TRUE(is(colour_of(root, 2), colour::ghost));
  EXPECT_EQ(colour_of(root, 0).at(3), 1);
  EXPECT_LT(colour_of(root, 2).at(3), 1) << "one sees through the ghost";
  EXPECT_TRUE(is(colour_of(root, 3), colour::contact));
  EXPECT_TRUE(is(colour_of(root, 4), colour::contact));
  EXPECT_TRUE(is(colour_of(root, 5), colour::force));
  EXPECT_LT(middle_of(root, 0).norm(), 1e-6);
  EXPECT_LT((middle_of(root, 1) - instant.probe.p).norm(), 1e-6);
  EXPECT_LT((middle_of(root, 2) - instant.separation.separated.p).norm(), 1e-6);
  const Contact& contact = instant.separation.clusters[0].contact;
  EXPECT_GT((middle_of(root, 3) - contact.on_fixed).dot(contact.normal), 0)
      << "an arrow leads from the fixed body out";
}

TEST_F(GltfTest, its_data_is_within_so_that_one_file_is_all) {
  const json root = written(made_up_instant());
  for (const auto& buffer : root.at("buffers"))
    EXPECT_THAT(buffer.at("uri").get<std::string>(), testing::StartsWith("data:"));
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST_F(GltfTest, a_free_probe_is_alone_with_the_fixed_body) {
  const json root = written(made_up_free_instant());
  EXPECT_EQ(root.at("meshes").size(), 2u);
}

TEST_F(GltfTest, without_a_force_there_is_no_arrow_of_it) {
  ExportedInstant instant = made_up_instant();
  instant.wrench = {};
  const json root = written(instant);
  ASSERT_EQ(root.at("meshes").size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_FALSE(is(colour_of(root, i), colour::force)) << i;
}

TEST_F(GltfTest, cancelled_leaves_the_file_that_was_there) {
  folder.write("scene.gltf", "old");
  for (const double at : {0.1, 0.5})
    EXPECT_THROW(write_gltf(folder / "scene.gltf", surfaces, made_up_instant(),
                            [at](double part) { return part < at; }),
                 Cancelled);
  EXPECT_EQ(sonde::test::text_of(folder / "scene.gltf"), "old");
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST_F(GltfTest, a_file_that_cannot_be_written_is_named) {
  const std::filesystem::path file = folder / "nowhere" / "scene.gltf";
  try {
    write_gltf(file, surfaces, made_up_instant());
    FAIL() << "there is no such folder";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr((folder / "nowhere").string()));
  }
}

}  // namespace
}  // namespace sonde::ui::test
