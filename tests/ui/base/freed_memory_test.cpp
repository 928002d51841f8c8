// SPDX-License-Identifier: GPL-3.0-or-later
// The reference is the kernel's count of the pages in use.

#include "ui/base/freed_memory.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <fstream>
#include <memory>
#include <vector>

#ifndef __SANITIZE_ADDRESS__  // which keeps freed memory to itself

namespace sonde::ui::test {
namespace {

double resident_bytes() {
  std::ifstream in("/proc/self/statm");
  double all = 0, here = 0;
  in >> all >> here;
  return here * double(sysconf(_SC_PAGESIZE));
}

std::unique_ptr<char[]> written(std::size_t bytes) {
  auto block = std::make_unique<char[]>(bytes);
  std::memset(block.get(), 1, bytes);
  return block;
}

TEST(FreedMemory, goes_back_to_the_system) {
  return_freed_memory();
  constexpr std::size_t bytes = 8 << 20, count = 16;
  written(2 * bytes).reset();  // from here on the C library would keep blocks of this size
  const double before = resident_bytes();
  std::vector<std::unique_ptr<char[]>> blocks;
  for (std::size_t i = 0; i < count; ++i) blocks.push_back(written(bytes));
  const auto below_the_top = written(100'000);  // in the heap, what lies below it would stay
  EXPECT_GT(resident_bytes() - before, 0.9 * double(count * bytes));
  blocks.clear();
  EXPECT_LT(resident_bytes() - before, 0.1 * double(count * bytes));
}

}  // namespace
}  // namespace sonde::ui::test

#endif
