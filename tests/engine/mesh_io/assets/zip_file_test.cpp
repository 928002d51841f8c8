// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/zip_file.hpp"

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "tests/engine/mesh_io/assets/asset_files.hpp"

namespace sonde {
namespace {

std::string why(const std::string& bytes, bool unpack = true) {
  const std::string file = "a.zip";
  try {
    const ZipFile zip(file, bytes);
    if (unpack)
      for (const ZipFile::Part& part : zip.parts()) zip.unpack(part);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ZipFile, parts_are_unpacked) {
  const std::string longer(100000, 'x');
  for (const bool deflated : {false, true}) {
    const std::string file = "a.zip", bytes = test::as_zip({{"A/b", longer}, {"c", ""}}, deflated);
    const ZipFile zip(file, bytes);
    ASSERT_EQ(zip.parts().size(), 2u);
    ASSERT_NE(zip.find("a/B"), nullptr) << "the case of letters does not count";
    EXPECT_EQ(zip.unpack(*zip.find("a/B")), longer);
    EXPECT_EQ(zip.unpack(*zip.find("c")), "");
    EXPECT_EQ(zip.find("b"), nullptr);
  }
}

TEST(ZipFile, what_is_packed_is_unpacked) {
  const std::string file = "a.zip", bytes = zip_of({{"A/b", "content"}, {"c", ""}});
  const ZipFile zip(file, bytes);
  ASSERT_EQ(zip.parts().size(), 2u);
  EXPECT_EQ(zip.unpack(*zip.find("A/b")), "content");
  EXPECT_EQ(bytes, test::as_zip({{"A/b", "content"}, {"c", ""}}, false));
}

TEST(ZipFile, faults) {
  const std::string good = test::as_zip({{"a", std::string(1000, 'x')}});
  EXPECT_EQ(why(good), "accepted");
  EXPECT_EQ(why("no zip"), "a.zip: not a ZIP file, or cut off: it has no directory");
  EXPECT_EQ(why(good.substr(0, good.size() - 30)),
            "a.zip: not a ZIP file, or cut off: it has no directory");
  const std::size_t directory = good.find("PK\1\2");
  std::string bad = good;
  bad[directory + 24] = 7;  // bytes unpacked: 1000 is 232 + 3 * 256
  EXPECT_EQ(why(bad),
            "a.zip: byte 0: the part \"a\" does not unpack to what the "
            "directory declares");
  bad = test::as_zip({{"a", "content"}}, false);
  bad[bad.find("content")] = 'C';
  EXPECT_NE(why(bad).find("does not unpack to what"), std::string::npos);
  bad = good;
  bad[directory + 10] = 12;
  EXPECT_EQ(why(bad), "a.zip: byte 0: the part \"a\" is packed in a way that is not read");
  bad = good;
  bad[directory + 22] = 1;  // 65536 bytes packed
  EXPECT_EQ(why(bad), "a.zip: byte 0: the part \"a\" is cut off");
  bad = good;
  bad[directory] = 'X';
  EXPECT_EQ(why(bad), "a.zip: byte " + std::to_string(directory) +
                          ": the directory of the ZIP file is damaged");
}

/// A file need not be large to unpack to more than a machine has.
TEST(ZipFile, a_bomb_is_refused_before_it_is_unpacked) {
  std::string bomb = test::as_zip({{"a", std::string(1000, 'x')}});
  bomb[bomb.find("PK\1\2") + 27] = 0x60;  // 1.6e9 bytes
  EXPECT_EQ(why(bomb, false), "a.zip: its parts unpack to more than 1024 MiB");
}

}  // namespace
}  // namespace sonde
