// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/study_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>

#include "engine/base/error.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::never;
using testing::ElementsAre;
using testing::HasSubstr;

/// Parts that write the square of their number, and count how often they are computed.
struct Squares {
  std::atomic<int> computed{0};
  Study study;

  explicit Squares(int n, const std::string& about = R"({"power": 2})") {
    study = {"squares", about, {}};
    for (int i = 0; i < n; ++i)
      study.parts.push_back({"part-" + std::to_string(i), [this, i](const Stop&) {
                               ++computed;
                               return std::to_string(i * i) + "\n";
                             }});
  }
};

std::vector<std::string> texts(const StudyFolder& folder) {
  std::vector<std::string> out;
  for (const auto& result : folder.results) out.push_back(result.value_or("-"));
  return out;
}

TEST(StudyParts, finished_ones_are_not_computed_again) {
  const test::TempFolder folder;
  Squares squares(4);
  compute_parts(folder.path(), squares.study, {}, 2, never);
  EXPECT_EQ(squares.computed, 4);
  const StudyFolder all = read_study(folder.path());
  EXPECT_TRUE(all.complete());
  EXPECT_EQ(all.kind, "squares");
  EXPECT_EQ(all.about, R"({"power":2})");
  EXPECT_THAT(texts(all), ElementsAre("0\n", "1\n", "4\n", "9\n"));

  std::filesystem::remove(folder / "parts" / "part-2.json");
  EXPECT_FALSE(read_study(folder.path()).complete());
  compute_parts(folder.path(), squares.study, {}, 1, never);
  EXPECT_EQ(squares.computed, 5);
  EXPECT_THAT(texts(read_study(folder.path())), ElementsAre("0\n", "1\n", "4\n", "9\n"));
}

TEST(StudyParts, at_once_in_memory_are_what_a_folder_holds) {
  const test::TempFolder folder;
  Squares squares(5);
  compute_parts(folder.path(), squares.study, {}, 1, never);
  const StudyFolder written = read_study(folder.path());
  const StudyFolder at_once = compute_at_once(squares.study, 3, never);
  EXPECT_EQ(at_once.kind, written.kind);
  EXPECT_EQ(at_once.about, written.about);
  EXPECT_EQ(at_once.names, written.names);
  EXPECT_EQ(texts(at_once), texts(written));
}

TEST(StudyParts, shards_together_are_the_whole) {
  for (const std::size_t count : {1u, 2u, 3u, 7u}) {
    const test::TempFolder folder;
    Squares squares(5);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      compute_parts(folder.path(), squares.study, {i, count}, 1, never,
                    [&](std::size_t, std::size_t, double) { ++sum; });
    EXPECT_EQ(squares.computed, 5);
    EXPECT_EQ(sum, 5u);
    EXPECT_TRUE(read_study(folder.path()).complete());
  }
}

TEST(StudyParts, of_one_that_says_how_far_it_is_that_is_told_before_it_ends) {
  const test::TempFolder folder;
  Study study{"squares", "{}", {}};
  const auto half_way = std::make_shared<std::atomic<double>>(0);
  study.parts.push_back({"long",
                         [&](const Stop& stop) {
                           for (const double done : {0.25, 0.5, 0.5, 0.75}) {
                             *half_way = done;
                             EXPECT_FALSE(stop());
                           }
                           return std::string("1");
                         },
                         half_way});
  study.parts.push_back({"silent", [](const Stop& stop) {
                           EXPECT_FALSE(stop());
                           return std::string("2");
                         }});
  std::vector<std::array<double, 3>> told;
  compute_parts(folder.path(), study, {}, 1, never,
                [&](std::size_t done, std::size_t total, double under_way) {
                  told.push_back({double(done), double(total), under_way});
                });
  EXPECT_EQ(told, (std::vector<std::array<double, 3>>{
                      {0, 2, 0.25}, {0, 2, 0.5}, {0, 2, 0.75}, {1, 2, 0}, {2, 2, 0}}));
}

TEST(StudyParts, stopped_in_the_middle_keeps_what_is_finished) {
  const test::TempFolder folder;
  Squares squares(6);
  EXPECT_THROW(
      compute_parts(folder.path(), squares.study, {}, 1, [&] { return squares.computed >= 3; }),
      Cancelled);
  EXPECT_EQ(squares.computed, 3);
  EXPECT_FALSE(read_study(folder.path()).complete());
  compute_parts(folder.path(), squares.study, {}, 2, never);
  EXPECT_EQ(squares.computed, 6);
  EXPECT_TRUE(read_study(folder.path()).complete());
}

TEST(StudyParts, a_part_that_fails_says_why_and_is_not_written) {
  const test::TempFolder folder;
  Squares squares(2);
  squares.study.parts.push_back(
      {"bad", [](const Stop&) -> std::string { throw std::runtime_error("no contact"); }});
  for (const unsigned threads : {1u, 3u}) {
    try {
      compute_parts(folder.path(), squares.study, {}, threads, never);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "no contact");
    }
    EXPECT_EQ(texts(read_study(folder.path()))[2], "-");
  }
}

TEST(StudyParts, a_folder_of_another_study_is_left_alone) {
  const test::TempFolder folder;
  Squares squares(2), other(2, R"({"power": 3})");
  compute_parts(folder.path(), squares.study, {}, 1, never);
  try {
    compute_parts(folder.path(), other.study, {}, 1, never);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("other inputs or settings"));
  }
  EXPECT_EQ(other.computed, 0);
  folder.write("study.json", "{\"study\": 3}");
  EXPECT_THROW(read_study(folder.path()), InputError);
  folder.write("study.json", R"({"study": "a", "about": {}, "parts": ["../x"]})");
  EXPECT_THROW(read_study(folder.path()), InputError);
}

TEST(StudyParts, a_folder_of_other_parts_of_the_same_study_is_carried_on) {
  const test::TempFolder folder;
  Squares few(2), all(4);
  compute_parts(folder.path(), few.study, {}, 1, never);
  EXPECT_THROW(compute_parts(folder.path(), all.study, {}, 1, [&] { return all.computed >= 1; }),
               Cancelled);
  EXPECT_EQ(all.computed, 1) << "two were there";
  EXPECT_THAT(texts(read_study(folder.path())), ElementsAre("0\n", "1\n", "4\n", "-"));
  // Half of all: asked for the few, it is finished, and knows of no more.
  compute_parts(folder.path(), few.study, {}, 1, never);
  EXPECT_EQ(few.computed, 2);
  EXPECT_THAT(texts(read_study(folder.path())), ElementsAre("0\n", "1\n"));
  compute_parts(folder.path(), all.study, {}, 1, never);
  EXPECT_EQ(all.computed, 2);
  // All of it, finished, is not made less.
  compute_parts(folder.path(), few.study, {}, 1, never);
  EXPECT_THAT(texts(read_study(folder.path())), ElementsAre("0\n", "1\n", "4\n", "9\n"));
}

/// What reading the folder complains of.
std::string complaint_about(const test::TempFolder& folder) {
  try {
    read_study(folder.path());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// Whatever walks to the bottom of such text (printing, comparing) recurses a million times.
TEST(StudyParts, text_nested_without_end_is_refused_and_brackets_in_strings_are_no_depth) {
  const std::string open(1000000, '['), close(1000000, ']');
  const test::TempFolder folder;
  folder.write("study.json",
               R"({"study": "trade", "about": )" + open + close + R"(, "parts": []})");
  EXPECT_THAT(complaint_about(folder), HasSubstr("study.json: is nested deeper"));
  std::filesystem::create_directories(folder.path() / "parts");
  folder.write("study.json",
               R"({"study": "trade", "about": ")" + open + R"(\"{", "parts": ["a"]})");
  folder.write("parts/a.json", open + close);
  EXPECT_THAT(complaint_about(folder), HasSubstr("a.json: is nested deeper"));
  folder.write("parts/a.json", "[\"[[[[\"]");
  EXPECT_EQ(complaint_about(folder), "");
}

TEST(StudyParts, a_part_whose_name_is_no_file_name_is_refused_in_a_line) {
  const test::TempFolder folder;
  for (const std::string& name : {std::string(5000, 'a'), std::string("../../etc/passwd")}) {
    folder.write("study.json", R"({"study": "t", "about": 1, "parts": [")" + name + R"("]})");
    EXPECT_NE(complaint_about(folder), "");
  }
}

TEST(StudyParts, shards_in_words) {
  const auto shard = shard_of("2/8");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->index, 1u);
  EXPECT_EQ(shard->count, 8u);
  for (const char* text : {"", "1", "0/3", "4/3", "1/", "/2", "-1/2", "1/2/3", "a/b", "1 /2"})
    EXPECT_FALSE(shard_of(text)) << text;
}

TEST(StudyParts, the_fingerprint_is_the_published_fnv1a) {
  // Test vectors of the authors (Fowler, Noll, Vo: fnv-1a, 64 bits).
  EXPECT_EQ(fingerprint(""), "cbf29ce484222325");
  EXPECT_EQ(fingerprint("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(fingerprint("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace sonde
