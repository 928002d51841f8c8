// SPDX-License-Identifier: GPL-3.0-or-later
// What the world does to the program: memory that ends, other locales, long and strange names, a
// home that takes nothing. The reference is the run to which nothing is done.
#include <stdlib.h>

#include <array>

#include "tests/app/app_test.hpp"
#include "tests/support/locales.hpp"

namespace sonde::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

class Faults : public AppTest {
 protected:
  /// A bumpy sheet of 2 (n − 1)² triangles.
  static std::string sheet_off(int n) {
    std::string text =
        "OFF\n" + std::to_string(n * n) + " " + std::to_string(2 * (n - 1) * (n - 1)) + " 0\n";
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        text += std::to_string(0.001 * i) + " " + std::to_string(0.001 * j) + " " +
                std::to_string(1e-5 * ((7 * i + 13 * j) % 17)) + "\n";
    for (int i = 0; i + 1 < n; ++i)
      for (int j = 0; j + 1 < n; ++j) {
        const int a = i * n + j;
        for (const auto& t : {std::array{a, a + 1, a + n}, std::array{a + 1, a + n + 1, a + n}})
          text += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " +
                  std::to_string(t[2]) + "\n";
      }
    return text;
  }

  const std::string query = "query boxes.sonde.json --poses poses.csv --json ";

  /// The result without the times, which differ from run to run.
  static std::string untimed(std::string json) {
    for (std::size_t at = 0; (at = json.find("\"time_us\":", at)) != std::string::npos; ++at)
      json.erase(at + 10, json.find_first_of(",}", at) - at - 10);
    return json;
  }
};

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they map terabytes at once
/// From a limit at which not even the words for the version fit, to one at which all does.
TEST_F(Faults, memory_that_ends_is_told_of_wherever_that_is) {
  folder.write("sheet.off", sheet_off(150));
  const std::size_t files = folder.file_count();
  int refused = 0, done = 0;
  for (int megabytes = 20; megabytes <= 200; megabytes += 9) {
    const std::string limit = "ulimit -v " + std::to_string(1024 * megabytes) + " &&";
    if (sonde_after(limit, "--version").exit_code != 0) continue;
    const Outcome run = sonde_after(limit,
                                    "query --probe sheet.off --fixed sheet.off --no-bound "
                                    "--budget-steps 1 --poses poses.csv --out r.csv");
    EXPECT_THAT(run.exit_code, AnyOf(0, 3, 4)) << megabytes << " MiB: " << run.err;
    if (run.exit_code == 0) {
      ++done;
      std::filesystem::remove(folder / "r.csv");
    } else {
      ++refused;
      EXPECT_THAT(run.err, HasSubstr("memory")) << megabytes << " MiB";
    }
    EXPECT_EQ(folder.file_count(), files) << megabytes << " MiB";
  }
  EXPECT_GT(refused, 0) << "no limit was too low";
  EXPECT_GT(done, 0) << "no limit was high enough";
}
#endif

/// The comma is decimal in German; "i" in capitals has a dot in Turkish, which finds no ".STI".
TEST_F(Faults, the_same_bits_in_german_and_in_turkish) {
  for (const char* name : {"de_DE", "tr_TR"}) make_locale(folder, name);
  std::filesystem::rename(folder / "small.off", folder / "TINI.OFF");
  folder.write("boxes.sonde.json",
               R"({"probe": {"mesh": "TINI.OFF", "scale": 1.5}, "fixed": {"mesh": "large.off"}})");
  const Outcome plain = expect_done(query);
  for (const std::string name : {"de_DE", "tr_TR"}) {
    const std::string set =
        "LOCPATH='" + (folder / "locales").string() + "' LC_ALL=" + name + ".UTF-8";
    const Outcome run = sonde_after(set, query);
    EXPECT_EQ(run.exit_code, 0) << name << ": " << run.err;
    EXPECT_EQ(untimed(run.out), untimed(plain.out)) << name;
  }
}

TEST_F(Faults, names_with_spaces_and_letters_of_any_script) {
  const std::string plain = untimed(sonde(query).out);
  for (const char* name : {"a b", "Körper 箱 é", "-begins", "a'b\"c", "\xff\xfe"}) {
    const std::filesystem::path sub = folder / name;
    std::filesystem::create_directory(sub);
    for (const char* file : {"small.off", "large.off", "boxes.sonde.json", "path.csv", "poses.csv"})
      std::filesystem::copy_file(folder / file, sub / file);
    ::setenv("SUB", ("./" + std::string(name)).c_str(), 1);
    const Outcome run = sonde_after("",
                                    "query \"$SUB/boxes.sonde.json\" --poses "
                                    "\"$SUB/poses.csv\" --json --out \"$SUB/r.json\"");
    EXPECT_EQ(run.exit_code, 0) << name << ": " << run.err;
    EXPECT_EQ(untimed(text_of(sub / "r.json")), plain) << name;
  }
  ::unsetenv("SUB");
}

TEST_F(Faults, names_of_four_thousand_letters_work_and_longer_ones_are_refused) {
  std::filesystem::path deep = folder.path();
  while (deep.string().size() < 3800) deep /= std::string(180, 'd');
  std::filesystem::create_directories(deep);
  const std::string last(4000 - deep.string().size() - 1, 'f');
  for (const char* file : {"small.off", "large.off", "boxes.sonde.json", "path.csv"})
    std::filesystem::copy_file(folder / file, deep / file);
  ::setenv("DEEP", deep.c_str(), 1);
  const std::string plain = untimed(sonde(query).out);
  const std::string deep_query =
      "query \"$DEEP/boxes.sonde.json\" --poses poses.csv --json --out \"$DEEP/";
  const Outcome run = sonde_after("", deep_query + last + "\"");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(untimed(text_of(deep / last)), plain);
  const std::size_t files = folder.file_count();
  const Outcome beyond = sonde_after("", deep_query + std::string(300, 'f') + "\"");
  EXPECT_EQ(beyond.exit_code, 3);
  EXPECT_THAT(beyond.err, HasSubstr("File name too long"));
  EXPECT_EQ(folder.file_count(), files);
  ::unsetenv("DEEP");
}

TEST_F(Faults, a_home_that_takes_nothing_is_not_needed) {
  const std::string plain = untimed(sonde(query).out);
  const std::string home = "HOME=/proc XDG_CONFIG_HOME=/proc XDG_CACHE_HOME=/proc ";
  const Outcome run = sonde_after(home, query);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(untimed(run.out), plain);
  EXPECT_EQ(sonde_after(home, "devices").exit_code, 0);
  EXPECT_EQ(sonde_after("env -u HOME", query).exit_code, 0);
}

/// SIGPIPE would end it without a word.
TEST_F(Faults, a_reader_that_goes_away_is_told_of) {
  std::string poses = "px,py,pz,qw,qx,qy,qz\n";
  for (int i = 0; i < 20000; ++i) poses += "9,0,0,1,0,0,0\n";  // more than a pipe holds
  folder.write("many.csv", poses);
  const std::string command = "cd '" + folder.path().string() +
                              "' && { '" SONDE_PROGRAM
                              "' query boxes.sonde.json --poses many.csv 2>err; echo $? >code; } | "
                              "head -c 10 >seen";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(text_of(folder / "seen"), "index,stat");
  EXPECT_EQ(text_of(folder / "code"), "3\n");
  EXPECT_THAT(text_of(folder / "err"), HasSubstr("standard output: cannot be written: "));
}

TEST_F(Faults, a_study_refuses_a_folder_that_holds_other_things) {
  for (const std::string letter : {"letter.txt", "parts/letter.txt", "parts/letter.json"}) {
    std::filesystem::create_directories(folder / "mine/parts");
    folder.write("mine/" + letter, "dear");
    for (const std::string study :
         {"trade", "tune --device sigma.7", "traces --device sigma.7", "compare"}) {
      const Outcome run = sonde(study + " boxes.sonde.json --out mine --quiet");
      EXPECT_EQ(run.exit_code, 3) << study;
      EXPECT_THAT(run.err, HasSubstr("mine: holds \"" + letter + "\" and no study")) << study;
    }
    EXPECT_EQ(text_of(folder / "mine" / letter), "dear");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "mine"))
      if (entry.is_regular_file()) ++files;
    EXPECT_EQ(files, 1u);
    std::filesystem::remove_all(folder / "mine");
  }
}

}  // namespace
}  // namespace sonde::test
