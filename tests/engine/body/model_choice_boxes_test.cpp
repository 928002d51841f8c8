// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "engine/body/model_choice.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"

namespace sonde {
namespace {

struct RandomBoxes {
  PolygonSoup mesh;
  std::set<std::array<int, 3>> cells;  // unit cells of the union
};

using Box = Eigen::AlignedBox3i;

std::vector<std::array<int, 3>> cells_of(const Box& box) {
  std::vector<std::array<int, 3>> cells;
  for (int x = box.min().x(); x < box.max().x(); ++x)
    for (int y = box.min().y(); y < box.max().y(); ++y)
      for (int z = box.min().z(); z < box.max().z(); ++z) cells.push_back({x, y, z});
  return cells;
}

/// Whether the others cover all of one of the boxes.
bool any_covered(const std::vector<Box>& boxes) {
  std::map<std::array<int, 3>, int> times;
  for (const Box& box : boxes)
    for (const auto& cell : cells_of(box)) ++times[cell];
  return std::ranges::any_of(boxes, [&](const Box& box) {
    return std::ranges::none_of(cells_of(box), [&](const auto& cell) { return times[cell] == 1; });
  });
}

/// Boxes with corners at small integers, so that they touch and cross in all ways, none within
/// another; in any order; some written twice, or some inside out: none where others cover one of
/// them, which would be a cavity if it were the other way round than they are.
RandomBoxes random_boxes(std::uint64_t seed, bool repeats, bool turns) {
  std::mt19937_64 random(seed);
  const auto below = [&random](std::uint64_t n) { return static_cast<int>(random() % n); };
  std::vector<Box> boxes;
  std::vector<PolygonSoup> parts;
  std::vector<bool> turned;
  RandomBoxes out;
  for (int left = 2 + below(3); left > 0; --left) {
    Box box;
    for (int k = 0; k < 3; ++k) {
      box.min()[k] = below(4);
      box.max()[k] = box.min()[k] + 1 + below(3);
    }
    if (std::ranges::any_of(boxes,
                            [&](const Box& b) { return b.contains(box) || box.contains(b); }))
      continue;
    boxes.push_back(box);
    const PolygonSoup part = test::triangulated(test::placed(
        test::box(box.sizes().cast<double>()), (box.min() + box.max()).cast<double>() / 2));
    turned.push_back(turns && below(2) == 0);
    parts.push_back(part);
    if (repeats && below(3) == 0) parts.push_back(below(2) == 0 ? test::turned_over(part) : part);
    for (const auto& cell : cells_of(box)) out.cells.insert(cell);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)  // with turns, there are no repeats
    if (turned[i] && !any_covered(boxes)) parts[i] = test::turned_over(parts[i]);
  std::ranges::shuffle(parts, random);
  for (const PolygonSoup& part : parts) out.mesh = test::joined(out.mesh, part);
  return out;
}

void expect_union_of_boxes(int count) {
  for (int seed = 0; seed < count; ++seed)
    for (const bool repeats : {false, true})
      for (const bool turns : {false, true}) {
        if (repeats && turns) continue;  // which of them is a copy is then not to be told
        const RandomBoxes boxes = random_boxes(static_cast<std::uint64_t>(seed), repeats, turns);
        Vec3 middle = Vec3::Zero();
        const double volume = static_cast<double>(boxes.cells.size());
        for (const auto& [x, y, z] : boxes.cells)
          middle += Vec3(x + 0.5, y + 0.5, z + 0.5) / volume;
        const auto body = test::body(boxes.mesh);
        ASSERT_TRUE(body->solid);
        EXPECT_NEAR(body->mass.measure, volume, 1e-5 * volume) << seed;
        EXPECT_LT((body->mass.com - middle).norm(), 1e-5 * body->mass.radius) << seed;
      }
}

// Reference: the unit cells of the union, counted.
TEST(ModelChoiceOfBoxes, that_touch_and_cross_is_their_union) { expect_union_of_boxes(60); }
TEST(ModelChoiceOfBoxes, Full_that_touch_and_cross_is_their_union) { expect_union_of_boxes(3000); }

}  // namespace
}  // namespace sonde
