// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/simd/instruction_set.hpp"

#include "tests/app/app_test.hpp"

namespace sonde::test {
namespace {

using ForcedInstructionSet = AppTest;

/// Reference: the narrowest vectors.
TEST_F(ForcedInstructionSet, gives_the_same_bits) {
  const std::string query = "query boxes.sonde.json --poses poses.csv --budget-steps 20";
  const Outcome narrow = sonde_after("SONDE_INSTRUCTION_SET=baseline", query);
  EXPECT_EQ(narrow.exit_code, 0) << narrow.err;
  for (const InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
    if (!is_supported(set)) continue;
    const std::string name(name_of(set));
    const std::string forced = "SONDE_INSTRUCTION_SET=" + name;
    EXPECT_EQ(sonde_after(forced, "--instruction-set").out, name + "\n");
    const Outcome run = sonde_after(forced, query);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(Csv(run.out).without({"time_us"}), Csv(narrow.out).without({"time_us"}));
  }
}

TEST_F(ForcedInstructionSet, of_another_name_is_refused) {
  const Outcome run = sonde_after("SONDE_INSTRUCTION_SET=sse", "info small.off");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err, "sonde: SONDE_INSTRUCTION_SET=sse: the sets are baseline, avx2 and avx512\n");
}

}  // namespace
}  // namespace sonde::test
