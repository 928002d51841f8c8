// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_inputs.hpp"

#include <gtest/gtest.h>

#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

TEST(TuningInputs, tell_apart_what_a_study_depends_on_and_not_where_it_lies) {
  const test::TempFolder here, there;
  for (const auto* folder : {&here, &there}) {
    folder->write("a.off", "one");
    folder->write("b.off", "another");
  }
  const auto body = test::body(test::box({1, 1, 1})), larger = test::body(test::box({2, 2, 2}));
  const auto inputs = [&](const test::TempFolder& folder, const Body& probe,
                          const std::string& version) {
    return tuning_inputs(version, {folder / "a.off", folder / "b.off", {}}, probe, *body);
  };
  const std::string own = inputs(here, *body, "1");
  EXPECT_EQ(inputs(there, *body, "1"), own);
  EXPECT_NE(inputs(here, *larger, "1"), own) << "the same mesh at another scale";
  EXPECT_NE(inputs(here, *body, "2"), own);
  there.write("a.off", "changed");
  EXPECT_NE(inputs(there, *body, "1"), own);
  EXPECT_NE(tuning_inputs("1", {here / "a.off", here / "b.off", here / "a.off"}, *body, *body),
            own);
}

}  // namespace
}  // namespace sonde
