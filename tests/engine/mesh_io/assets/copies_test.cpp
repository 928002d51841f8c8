// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/copies.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/base/error.hpp"
#include "engine/mesh_io/assets/asset_readers.hpp"

namespace sonde {
namespace {

/// A chain of so many objects that each place the next so often; the last has these corners.
std::string check(int length, int times, double corners) {
  Copies copies;
  for (int k = 0; k <= length; ++k) copies.add(k == length ? corners : 0);
  for (int k = 0; k < length; ++k)
    for (int i = 0; i < times; ++i)
      copies.place(static_cast<std::size_t>(k), static_cast<std::size_t>(k) + 1);
  try {
    EXPECT_EQ(copies.count("f", 0), corners * std::pow(times, length));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// The counts are powers of two.
TEST(Copies, are_counted_before_they_are_made) {
  const std::string many = "f: its copies have more than 10000000 triangles in all";
  EXPECT_EQ(check(10, 2, most_corners / 1024), "accepted");
  EXPECT_EQ(check(10, 2, most_corners / 1023), many);
  EXPECT_EQ(check(60, 2, 3), many);
  EXPECT_EQ(check(60, 2, 0), many) << "copies of nothing take memory, too";
  EXPECT_EQ(check(Copies::most_depth, 1, 3), "accepted");
  EXPECT_EQ(check(Copies::most_depth + 1, 1, 3),
            "f: objects are placed within objects more than 200 deep");
  EXPECT_EQ(check(100000, 1, 3), "f: objects are placed within objects more than 200 deep");
}

TEST(Copies, an_object_inside_itself) {
  Copies copies;
  for (int k = 0; k < 3; ++k) copies.add(3);
  copies.place(0, 1);
  copies.place(1, 2);
  copies.place(2, 1);
  EXPECT_THROW(copies.count("f", 0), InputError);
  EXPECT_TRUE(copies.is_placed(1));
  EXPECT_FALSE(copies.is_placed(0));
}

}  // namespace
}  // namespace sonde
