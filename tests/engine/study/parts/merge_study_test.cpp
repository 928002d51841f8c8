// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/merge_study.hpp"

#include <gmock/gmock.h>

#include <map>

#include "engine/base/error.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;
using test::never;
using test::TempFolder;
using testing::HasSubstr;

Study study(int parts, const std::string& about = R"({"k": 500.0})", int changed = -1) {
  Study out{"numbers", about, {}};
  for (int i = 0; i < parts; ++i)
    out.parts.push_back({"part-" + std::to_string(i), [i, changed](const Stop&) {
                           return "{\"n\": " + std::to_string(i == changed ? -1 : i) + "}\n";
                         }});
  return out;
}

/// Every file below a folder, with what it holds.
std::map<std::string, std::string> files(const fs::path& folder) {
  std::map<std::string, std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      out[fs::relative(entry.path(), folder).string()] = test::text_of(entry.path());
  return out;
}

std::string reason_of(const std::vector<fs::path>& folders) {
  try {
    merge_studies(folders);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MergeStudy, joined_shards_are_the_unsplit_run_to_the_bit) {
  const TempFolder folder;
  compute_parts(folder / "whole", study(7), {}, 2, never);
  for (std::size_t i = 0; i < 3; ++i)
    compute_parts(folder / std::to_string(i), study(7), {i, 3}, 1, never);
  write_study(folder / "joined",
              merge_studies(std::vector<fs::path>{folder / "2", folder / "0", folder / "1"}));
  EXPECT_EQ(files(folder / "joined"), files(folder / "whole"));
}

TEST(MergeStudy, shards_may_overlap_share_a_folder_and_be_joined_in_it) {
  const TempFolder folder;
  compute_parts(folder / "whole", study(5), {}, 1, never);
  compute_parts(folder / "a", study(5), {0, 2}, 1, never);
  compute_parts(folder / "a", study(5), {1, 2}, 1, never);
  const StudyFolder joined = merge_studies(std::vector<fs::path>{folder / "a", folder / "whole"});
  EXPECT_TRUE(joined.complete());
  write_study(folder / "a", joined);
  EXPECT_EQ(files(folder / "a"), files(folder / "whole"));
}

TEST(MergeStudy, missing_parts_are_named) {
  const TempFolder folder;
  compute_parts(folder / "a", study(6), {0, 3}, 1, never);
  compute_parts(folder / "b", study(6), {1, 3}, 1, never);
  const std::string reason = reason_of({folder / "a", folder / "b"});
  EXPECT_THAT(reason, HasSubstr("part-2, part-5"));
  EXPECT_THAT(reason, testing::Not(HasSubstr("part-1")));
  EXPECT_THAT(reason_of({folder / "a"}), HasSubstr("part-4"));
}

TEST(MergeStudy, parts_that_differ_are_named_with_their_folders) {
  const TempFolder folder;
  compute_parts(folder / "a", study(3), {}, 1, never);
  compute_parts(folder / "b", study(3, R"({"k": 500.0})", 1), {}, 1, never);
  const std::string reason = reason_of({folder / "a", folder / "b"});
  for (const std::string& word :
       {std::string("part-1"), (folder / "a").string(), (folder / "b").string()})
    EXPECT_THAT(reason, HasSubstr(word));
}

/// One part, with a time in it.
Study timed(const std::string& time, const std::string& depth) {
  return {"numbers", "{}", {{"part-0", [=](const Stop&) {
                               return "{\"runs\":[{\"time_us\":" + time + ",\"depth\":" + depth +
                                      "}],\"time_us\":[1," + time + "]}";
                             }}}};
}

TEST(MergeStudy, times_may_differ_and_those_of_the_first_folder_are_kept) {
  const TempFolder folder;
  compute_parts(folder / "a", timed("10.5", "0.25"), {}, 1, never);
  compute_parts(folder / "b", timed("11", "0.25"), {}, 1, never);
  compute_parts(folder / "c", timed("10.5", "0.26"), {}, 1, never);
  EXPECT_EQ(merge_studies(std::vector<fs::path>{folder / "a", folder / "b"}).results,
            read_study(folder / "a").results);
  EXPECT_EQ(merge_studies(std::vector<fs::path>{folder / "b", folder / "a"}).results,
            read_study(folder / "b").results);
  EXPECT_THAT(reason_of({folder / "a", folder / "b", folder / "c"}), HasSubstr("another result"));
}

TEST(MergeStudy, different_studies_are_not_joined) {
  const TempFolder folder;
  compute_parts(folder / "a", study(3), {}, 1, never);
  compute_parts(folder / "b", study(3, R"({"k": 501.0})"), {}, 1, never);
  compute_parts(folder / "c", study(4), {}, 1, never);
  EXPECT_THAT(reason_of({folder / "a", folder / "b"}), HasSubstr("another study"));
  EXPECT_THAT(reason_of({folder / "a", folder / "c"}), HasSubstr("another study"));
  EXPECT_THAT(reason_of({folder / "a", folder / "none"}), HasSubstr("none"));
}

}  // namespace
}  // namespace sonde
