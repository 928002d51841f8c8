// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/base/sentences.hpp"

#include <gtest/gtest.h>

#include <array>

namespace sonde {
namespace {

TEST(Sentences, are_those_given_in_their_order_in_every_copy) {
  const std::array<std::string, 2> given{"one", "two"};
  Sentences copy;
  EXPECT_TRUE(copy.empty());
  EXPECT_EQ(copy.begin(), copy.end());
  {
    const Sentences all(given.data(), given.data() + given.size());
    copy = all;
  }
  ASSERT_EQ(copy.size(), 2u);
  EXPECT_EQ(copy[0], "one");
  EXPECT_EQ(copy[1], "two");
  std::size_t i = 0;
  for (const std::string& sentence : copy) EXPECT_EQ(sentence, given[i++]);
  EXPECT_EQ(i, 2u);
}

}  // namespace
}  // namespace sonde
