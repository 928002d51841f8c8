// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/contact/separation.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace sonde {
namespace {

// The words are those of the manual (resources/docs/use/files.md) and of files written before.
TEST(Separation, methods_have_the_words_of_files) {
  EXPECT_STREQ(name_of(Method::pdg), "pdg");
  EXPECT_STREQ(name_of(Method::pdt), "pdt");
}

TEST(Separation, a_word_gives_its_method) {
  EXPECT_EQ(method_named("pdg"), Method::pdg);
  EXPECT_EQ(method_named("pdt"), Method::pdt);
}

TEST(Separation, any_other_word_is_no_method) {
  for (const std::string& word :
       std::initializer_list<std::string>{"", "PDT", "pd", "pdtt", " pdt", "separated"})
    EXPECT_FALSE(method_named(word)) << word;
}

}  // namespace
}  // namespace sonde
