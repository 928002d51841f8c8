// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/simd/instruction_set.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

/// The environment variable has a value while this lasts.
class Named {
 public:
  explicit Named(const char* set) {
    if (const char* const before = std::getenv(variable)) before_ = before;
    setenv(variable, set, 1);
  }
  ~Named() { before_ ? setenv(variable, before_->c_str(), 1) : unsetenv(variable); }

 private:
  static constexpr const char* variable = "SONDE_INSTRUCTION_SET";
  std::optional<std::string> before_;
};

std::string refusal() {
  try {
    check_instruction_set();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(InstructionSet, that_which_is_named_is_chosen_where_the_processor_runs_it) {
  for (int i = 0; i < static_cast<int>(InstructionSet::count); ++i) {
    const auto set = static_cast<InstructionSet>(i);
    const Named named(std::string(name_of(set)).c_str());
    if (is_supported(set)) {
      EXPECT_EQ(chosen_instruction_set(), set);
      EXPECT_EQ(refusal(), "");
    } else {
      EXPECT_TRUE(is_supported(chosen_instruction_set()));
      EXPECT_THAT(refusal(), testing::HasSubstr("this processor does not run it"));
    }
  }
}

TEST(InstructionSet, another_name_is_refused_and_has_no_effect) {
  for (const char* const name : {"", "AVX2", "avx", "neon"}) {
    const Named named(name);
    EXPECT_TRUE(is_supported(chosen_instruction_set())) << name;
    EXPECT_EQ(refusal(), std::string("SONDE_INSTRUCTION_SET=") + name +
                             ": the sets are baseline, avx2 and avx512");
  }
}

TEST(InstructionSet, is_that_of_the_first_call) {
  const InstructionSet first = instruction_set();
  const Named named(first == InstructionSet::baseline ? "avx2" : "baseline");
  EXPECT_EQ(instruction_set(), first);
}

}  // namespace
}  // namespace sonde
