// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mending/repair_sentences.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sonde {
namespace {

TEST(Repairs, none_say_nothing) {
  EXPECT_FALSE(Repairs().any());
  EXPECT_TRUE(sentences(Repairs()).empty());
}

TEST(Repairs, each_is_said_once_with_its_count_and_unit) {
  Repairs r;
  r.joined = 1;
  r.reach = 1e-7;
  r.on_edges = 2;
  r.unsearched = 30'000;
  r.turned_triangles = 1;
  r.parts = 3;
  r.turned_parts = 1;
  r.caps = 2;
  r.cap_triangles = 5;
  r.cap_area = 0.25;
  r.widest_cap = 0.011;
  r.overlaps = true;
  r.overlap_error = 2e-6;
  EXPECT_TRUE(r.any());
  EXPECT_THAT(
      sentences(r),
      testing::ElementsAre(
          "1 corner joined with others up to 1e-07 m away",
          "2 corners found on edges of others, which count as cut",
          "30000 open edges, too many to look for corners that lie on them (T-junctions): "
          "such edges stay open, are capped, and may leave parts that belong together apart",
          "1 triangle turned to agree with neighbours", "1 part of 3 inside out, turned",
          "2 openings closed by 5 triangles of 0.25 m², the widest 1.1 % of what "
          "is seen from outside",
          "parts that overlap are counted once, to 2e-06 of the volume"));
}

TEST(Repairs, a_mass_of_unknown_error_is_said) {
  Repairs r;
  r.overlap_unknown = true;
  EXPECT_THAT(sentences(r), testing::ElementsAre(testing::HasSubstr("is not known")));
}

TEST(Repairs, parts_that_stay_open_beside_closed_ones_are_said) {
  const auto said = [](std::size_t closed, std::size_t all) {
    Repairs r;
    r.parts = all;
    r.solid_parts = closed;
    return sentences(r);
  };
  EXPECT_THAT(said(2, 27),
              testing::ElementsAre("25 of 27 parts stay open: only their triangles count"));
  EXPECT_THAT(said(1, 2),
              testing::ElementsAre("1 of 2 parts stays open: only its triangles count"));
  EXPECT_TRUE(said(3, 3).empty());
  EXPECT_TRUE(said(0, 2).empty()) << "a surface says why by itself";
}

}  // namespace
}  // namespace sonde
