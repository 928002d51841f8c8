// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/pair_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/body/body.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using testing::HasSubstr;

std::string complaint_of(const auto& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

class PairFile : public testing::Test {
 protected:
  std::string text() const {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void put(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }
  std::string complaint() const {
    return complaint_of([&] { read_pair(file, knot, ring); });
  }

  test::TempFolder folder;
  std::filesystem::path file = folder / "kept.pair";
  std::shared_ptr<const Body> knot = test::body(test::torus_knot(2, 3, 0.1, 0.04, 0.03, 40, 8));
  std::shared_ptr<const Body> ring = test::body(test::torus(0.08, 0.03, 24, 12));
};

// Reference: the pair that was made.
TEST_F(PairFile, what_is_read_back_answers_to_the_bit_as_what_was_made) {
  const Pair made(knot, ring);
  write_pair(file, made);
  const Pair read = read_pair(file, knot, ring);
  std::mt19937_64 random(3);
  int deep = 0;
  for (int i = 0; i < 6; ++i) {
    const Pose X = test::random_pose(random, *knot, *ring, 0.5);
    const Separation a = separate_static(made, X, {}), b = separate_static(read, X, {});
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(std::memcmp(&a.separated, &b.separated, sizeof(Pose)), 0);
    EXPECT_EQ(a.iterations, b.iterations);
    deep += a.depth > 0;
  }
  EXPECT_GT(deep, 3);
  const std::string before = text();
  write_pair(file, read);
  EXPECT_EQ(text(), before);
}

TEST_F(PairFile, two_surfaces_have_nothing_to_keep_and_are_read_back_all_the_same) {
  std::mt19937_64 random(3);
  const auto soup = test::body(test::random_soup(random, 30, 0.2));
  write_pair(file, Pair(soup, soup));
  EXPECT_EQ(separate_static(read_pair(file, soup, soup), {}, {}).depth,
            separate_static(Pair(soup, soup), {}, {}).depth);
}

TEST_F(PairFile, other_bodies_are_refused_by_name) {
  write_pair(file, Pair(knot, ring));
  EXPECT_THAT(complaint_of([&] { read_pair(file, ring, knot); }),
              HasSubstr("kept.pair: was written for another probe"));
  EXPECT_THAT(complaint_of([&] { read_pair(file, knot, knot); }),
              HasSubstr("was written for another fixed body"));
  MassProperties heavier = ring->mass;
  heavier.inertia *= 2;
  EXPECT_THAT(complaint_of([&] { read_pair(file, knot, with_other_mass(*ring, heavier)); }),
              HasSubstr("was written for another fixed body"));
  EXPECT_THAT(complaint_of([&] { read_pair(file, knot, nullptr); }), HasSubstr("needs two bodies"));
}

TEST_F(PairFile, what_is_damaged_cut_or_no_such_file_is_refused_and_says_so) {
  write_pair(file, Pair(knot, ring));
  const std::string whole = text();
  for (const std::size_t at : {whole.size() / 3, whole.size() / 2, whole.size() - 1}) {
    std::string bad = whole;
    bad[at] = static_cast<char>(bad[at] ^ 1);
    put(bad);
    EXPECT_THAT(complaint(), HasSubstr("kept.pair: is damaged"));
    put(whole.substr(0, at));
    EXPECT_THAT(complaint(), HasSubstr("kept.pair: is damaged"));
  }
  std::string other = whole;
  other[std::strlen("sonde pair ")] = '9';
  put(other);
  EXPECT_THAT(complaint(), HasSubstr("another version"));
  put("solid box");
  EXPECT_THAT(complaint(), HasSubstr("is not a file of a pair"));
  std::filesystem::remove(file);
  EXPECT_THAT(complaint(), HasSubstr("kept.pair"));
}

}  // namespace
}  // namespace sonde
