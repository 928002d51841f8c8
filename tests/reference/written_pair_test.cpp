// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/written_pair.hpp"

#include <gtest/gtest.h>

#include "engine/mesh_io/read_mesh.hpp"
#include "engine/scene/poses.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::reference {
namespace {

TEST(WrittenPair, is_read_back_to_the_bit) {
  const test::TempFolder folder;
  const auto ring = test::body(test::torus(0.07, 0.02, 12, 7));
  const auto box = test::body(test::box({0.1, 0.2, 1.0 / 3}));
  Row row;
  row.pair = "ring-box";
  row.pose = {Quat(0.1, 0.2, 0.3, 0.4).normalized(), Vec3(1.0 / 7, 1e-17, -3)};
  const std::vector<Row> rows{row, row};
  write_pair(folder.path(), *ring, *box, rows);

  const PolygonSoup read = read_mesh(folder / "ring-box.probe.off");
  ASSERT_EQ(read.points.size(), ring->soup.vertices.size());
  for (std::size_t i = 0; i < read.points.size(); ++i)
    EXPECT_EQ(read.points[i], ring->soup.vertices[i]) << i;
  EXPECT_EQ(read.polygons.size(), ring->soup.triangles.size());
  EXPECT_EQ(read_mesh(folder / "ring-box.fixed.off").points.size(), 8u);
  const std::vector<Pose> poses = read_poses(folder / "ring-box.csv");
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[1].p, row.pose.p);
  // Reading makes its length one again.
  EXPECT_LT((poses[1].q.coeffs() - row.pose.q.coeffs()).norm(), 1e-15);
}

}  // namespace
}  // namespace sonde::reference
