// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/component_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

/// Two tetrahedra, the second 10 further along x.
std::string two_tetrahedra() {
  std::string text = "OFF\n8 8 0\n";
  for (const char* x : {"0", "10"})
    for (const char* corner : {" 0 0", " 1 0", " 0 1"}) text += x + std::string(corner) + "\n";
  text += "1 0 0\n11 0 0\n";
  for (const int i : {0, 3}) {
    const auto face = [&](int a, int b, int c) {
      text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    };
    const int a = i, b = i + 1, c = i + 2, d = i == 0 ? 6 : 7;
    face(a, b, c), face(a, d, b), face(a, c, d), face(b, d, c);
  }
  return text;
}

TEST(ComponentFiles, of_a_file_are_its_pieces_times_the_scale) {
  const test::TempFolder folder;
  const auto file = folder.write("two.off", two_tetrahedra());
  ComponentFiles files;
  const std::vector<PolygonSoup>& pieces = files.of(file, 0.5);
  ASSERT_EQ(pieces.size(), 2u);
  for (const PolygonSoup& piece : pieces) {
    EXPECT_EQ(piece.points.size(), 4u);
    EXPECT_EQ(piece.polygons.size(), 4u);
  }
  const auto highest = [](const PolygonSoup& piece) {
    double most = 0;
    for (const Vec3& x : piece.points) most = std::max(most, x.x());
    return most;
  };
  EXPECT_EQ(highest(pieces[0]), 0.5);
  EXPECT_EQ(highest(pieces[1]), 5.5);
  EXPECT_EQ(highest(files.of(file, 2).at(1)), 22);  // another scale is read anew
}

TEST(ComponentFiles, a_file_is_read_once) {
  const test::TempFolder folder;
  const auto file = folder.write("two.off", two_tetrahedra());
  ComponentFiles files;
  const std::vector<PolygonSoup>* first = &files.of(file, 1);
  files.of(file, 2);
  std::filesystem::remove(file);
  EXPECT_EQ(&files.of(file, 1), first);
  EXPECT_THROW(files.of(file, 3), InputError);
  EXPECT_THROW(ComponentFiles().of(file, 1), InputError);
}

TEST(ComponentFiles, several_threads_get_the_same) {
  const test::TempFolder folder;
  const auto file = folder.write("two.off", two_tetrahedra());
  ComponentFiles files;
  std::vector<const std::vector<PolygonSoup>*> got(8);
  std::vector<std::thread> threads;
  for (auto& one : got) threads.emplace_back([&] { one = &files.of(file, 1); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::ranges::count(got, got.front()), 8);
  EXPECT_EQ(got.front()->size(), 2u);
}

TEST(ComponentFiles, what_was_cancelled_is_read_the_next_time) {
  const test::TempFolder folder;
  const auto file = folder.write("two.off", two_tetrahedra());
  ComponentFiles files;
  EXPECT_THROW(files.of(file, 1, [](double) { return false; }), Cancelled);
  std::vector<double> told;
  EXPECT_EQ(files.of(file, 1, [&](double share) { return told.push_back(share), true; }).size(),
            2u);
  ASSERT_FALSE(told.empty());
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_LE(told.back(), 1);
  EXPECT_GT(told.back(), 0.5);  // both halves are told
}

}  // namespace
}  // namespace sonde
