// SPDX-License-Identifier: GPL-3.0-or-later
// What is written for ParaView, read back by VTK's own readers.
#include "ui/export/vtk_scene.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCubeSource.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/ui/export/made_up_instant.hpp"

namespace sonde::ui::test {
namespace {

namespace fs = std::filesystem;
using sonde::test::TempFolder;

vtkSmartPointer<vtkPolyData> cube_surface(double side) {
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(side);
  cube->SetYLength(side);
  cube->SetZLength(side);
  cube->Update();
  return cube->GetOutput();
}

Surfaces two_cubes() { return {cube_surface(0.02), cube_surface(0.1), Vec3(0.001, 0.002, 0.003)}; }

Vec3 value_at(vtkPolyData& data, const char* name, vtkIdType point) {
  vtkDataArray* array = data.GetPointData()->GetArray(name);
  if (!array) {
    ADD_FAILURE() << "there is no " << name;
    return Vec3::Zero();
  }
  Vec3 out = Vec3::Zero();
  for (int i = 0; i < array->GetNumberOfComponents(); ++i) out[i] = array->GetComponent(point, i);
  return out;
}

/// The blocks of a file, by their names.
struct ReadBlocks {
  vtkSmartPointer<vtkMultiBlockDataSet> all;

  explicit ReadBlocks(const fs::path& file) {
    vtkNew<vtkXMLMultiBlockDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    all = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  }
  vtkPolyData* operator[](const std::string& name) const {
    for (unsigned i = 0; all && i < all->GetNumberOfBlocks(); ++i)
      if (all->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) == name)
        return vtkPolyData::SafeDownCast(all->GetBlock(i));
    return nullptr;
  }
};

Vec3 centre_of(vtkPolyData& data) {
  double centre[3];
  data.ComputeBounds();
  data.GetCenter(centre);
  return Vec3(centre);
}

TEST(SurfaceAt, is_moved_and_the_surface_itself_stays) {
  const auto surface = cube_surface(0.02);
  const Pose pose{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 1, 0).normalized())), Vec3(1, 2, 3)};
  const auto moved = surface_at(*surface, pose);
  ASSERT_EQ(moved->GetNumberOfPoints(), surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    EXPECT_LT((Vec3(moved->GetPoint(i)) - pose * Vec3(surface->GetPoint(i))).norm(), 1e-6);
  EXPECT_LT(centre_of(*surface).norm(), 1e-9);
}

TEST(ContactPoints, each_cluster_is_a_point_on_the_fixed_body_with_its_numbers) {
  const ExportedInstant instant = made_up_instant();
  const auto points = contact_points(instant);
  ASSERT_EQ(points->GetNumberOfPoints(), 2);
  EXPECT_EQ(points->GetNumberOfVerts(), 2) << "without cells ParaView shows nothing";
  const Contact& first = instant.separation.clusters[0].contact;
  EXPECT_EQ(Vec3(points->GetPoint(0)), first.on_fixed);
  EXPECT_EQ(value_at(*points, "normal", 0), first.normal);
  EXPECT_EQ(value_at(*points, "on probe [m]", 0), first.on_probe);
  EXPECT_EQ(value_at(*points, "gap [m]", 0).x(), first.gap);
  EXPECT_EQ(value_at(*points, "multiplier [m]", 1).x(), 0.001);
  EXPECT_DOUBLE_EQ(value_at(*points, "share of force", 0).x(), 0.75);
  EXPECT_EQ(value_at(*points, "cluster", 1).x(), 11);
}

TEST(ContactPoints, a_probe_that_is_not_held_has_none_whatever_is_left_in_the_separation) {
  ExportedInstant instant = made_up_instant();
  instant.separation.status = Status::failed;
  EXPECT_EQ(contact_points(instant)->GetNumberOfPoints(), 0);
  EXPECT_TRUE(contact_points(instant)->GetPointData()->GetArray("gap [m]")) << "its names stay";
}

TEST(WrenchPoint, is_the_centre_of_mass_with_force_and_torque) {
  const ExportedInstant instant = made_up_instant();
  const Vec3 com(0.001, 0.002, 0.003);
  const auto point = wrench_point(instant, com);
  ASSERT_EQ(point->GetNumberOfPoints(), 1);
  EXPECT_LT((Vec3(point->GetPoint(0)) - instant.separation.device * com).norm(), 1e-15);
  EXPECT_EQ(value_at(*point, "force [N]", 0), instant.wrench.force);
  EXPECT_EQ(value_at(*point, "torque [N m]", 0), instant.wrench.torque);
}

TEST(WriteVtk, one_instant_is_one_file_of_five_blocks) {
  const TempFolder folder;
  const ExportedInstant instant = made_up_instant();
  write_vtk(folder / "out", two_cubes(), std::span(&instant, 1));
  EXPECT_FALSE(fs::exists(folder / "out" / "sonde.vtm.series"));
  const ReadBlocks blocks(folder / "out" / "sonde.vtm");
  for (const char* name : {"fixed", "probe", "ghost", "contacts", "wrench"})
    ASSERT_TRUE(blocks[name]) << name;
  EXPECT_LT(centre_of(*blocks["fixed"]).norm(), 1e-6);
  EXPECT_LT((centre_of(*blocks["probe"]) - instant.probe.p).norm(), 1e-6);
  EXPECT_LT((centre_of(*blocks["ghost"]) - instant.separation.separated.p).norm(), 1e-6);
  EXPECT_EQ(blocks["contacts"]->GetNumberOfPoints(), 2);
  vtkFieldData* numbers = blocks["probe"]->GetFieldData();
  EXPECT_EQ(numbers->GetArray("depth [m]")->GetTuple1(0), 0.021);
  EXPECT_EQ(numbers->GetArray("time [s]")->GetTuple1(0), 1.25);
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WriteVtk, a_series_says_the_time_of_each_and_has_the_fixed_body_once) {
  const TempFolder folder;
  const std::vector<ExportedInstant> instants{made_up_instant(), made_up_free_instant()};
  write_vtk(folder / "out", two_cubes(), instants);
  const auto series =
      nlohmann::json::parse(sonde::test::text_of(folder / "out" / "sonde.vtm.series"));
  ASSERT_EQ(series.at("files").size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& entry = series.at("files").at(i);
    EXPECT_EQ(entry.at("time").get<double>(), instants[i].time);
    const ReadBlocks blocks(folder / "out" / entry.at("name").get<std::string>());
    ASSERT_TRUE(blocks["probe"]);
    EXPECT_LT((centre_of(*blocks["probe"]) - instants[i].probe.p).norm(), 1e-6);
    EXPECT_TRUE(blocks["fixed"]);
  }
  std::size_t of_fixed = 0;
  for (const auto& entry : fs::directory_iterator(folder / "out"))
    of_fixed += entry.path().filename().string().starts_with("fixed");
  EXPECT_EQ(of_fixed, 1u);
}

TEST(WriteVtk, tells_how_far_it_is_and_cancelled_leaves_no_folder) {
  const TempFolder folder;
  const std::vector<ExportedInstant> instants(4, made_up_instant());
  std::vector<double> told;
  write_vtk(folder / "out", two_cubes(), instants, [&](double part) {
    told.push_back(part);
    return true;
  });
  ASSERT_GE(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1);
  for (const double at : {0.0, 0.5, 1.0})
    EXPECT_THROW(write_vtk(folder / "given-up", two_cubes(), instants,
                           [at](double part) { return part < at; }),
                 Cancelled)
        << at;
  EXPECT_EQ(folder.file_count(), 1u);
}

TEST(WriteVtk, takes_no_folder_that_is_there_and_names_what_cannot_be_written) {
  const TempFolder folder;
  const ExportedInstant instant = made_up_instant();
  fs::create_directory(folder / "mine");
  for (const fs::path& to : {folder / "mine", folder / "nowhere" / "out"}) try {
      write_vtk(to, two_cubes(), std::span(&instant, 1));
      ADD_FAILURE() << to;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(to.string() + ":"));
    }
  EXPECT_TRUE(fs::is_empty(folder / "mine"));
}

}  // namespace
}  // namespace sonde::ui::test
