// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/surface.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "tests/support/shapes.hpp"

namespace sonde::ui {
namespace {

// Reference: a traversal that nothing else has touched.
TEST(Surface, a_shell_is_traversed_apart_from_what_is_drawn) {
  const auto drawn = make_surface(sonde::test::body(sonde::test::box({1, 2, 3}))->soup);
  const auto shell = shell_of(*drawn);
  ASSERT_EQ(shell->GetNumberOfPolys(), 12);
  vtkNew<vtkIdList> second, next;
  drawn->GetPolys()->InitTraversal();
  drawn->GetPolys()->GetNextCell(next);
  drawn->GetPolys()->GetNextCell(second);

  drawn->GetPolys()->InitTraversal();
  drawn->GetPolys()->GetNextCell(next);
  shell->GetPolys()->InitTraversal();
  int seen = 0;
  while (shell->GetPolys()->GetNextCell(next)) ++seen;
  EXPECT_EQ(seen, 12);
  ASSERT_TRUE(drawn->GetPolys()->GetNextCell(next));
  for (vtkIdType i = 0; i < 3; ++i) EXPECT_EQ(next->GetId(i), second->GetId(i)) << i;
}

TEST(Surface, a_shell_shares_what_is_large) {
  const auto drawn = make_surface(sonde::test::body(sonde::test::box({1, 2, 3}))->soup);
  const auto shell = shell_of(*drawn);
  EXPECT_EQ(shell->GetPoints()->GetData(), drawn->GetPoints()->GetData());
  EXPECT_EQ(shell->GetPolys()->GetConnectivityArray(), drawn->GetPolys()->GetConnectivityArray());
  EXPECT_EQ(shell->GetPointData()->GetNormals(), drawn->GetPointData()->GetNormals());
}

}  // namespace
}  // namespace sonde::ui
