// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <csignal>

namespace sonde::test {
namespace {

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

[[gnu::noinline]] void this_function_crashes() {
  raise(SIGSEGV);
  asm volatile("");  // the call above is no last one: this function stays on the stack
}

TEST(CrashTraceDeathTest, names_the_function_and_the_signal_stays) {
  EXPECT_EXIT(this_function_crashes(), testing::KilledBySignal(SIGSEGV), "this_function_crashes");
}

#endif

}  // namespace
}  // namespace sonde::test
