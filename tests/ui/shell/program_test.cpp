// SPDX-License-Identifier: GPL-3.0-or-later
// These tests run the real sonde-view and look at its exit code, its output and its pictures.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <cstdlib>
#include <string>

#include "tests/ui/shell/program_fixture.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/shell/demo.hpp"

namespace sonde::ui::test {
namespace {

using ::testing::HasSubstr;

TEST_F(Program, help_and_version_need_no_display) {
  EXPECT_EQ(run("--version", "DISPLAY=").out, "sonde-view " SONDE_VERSION "\n");
  const Outcome help = run("--help", "DISPLAY=");
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, HasSubstr("--demo"));
  EXPECT_THAT(help.out, HasSubstr("[files...]"));
}

TEST_F(Program, wrong_usage_is_2) {
  EXPECT_EQ(run("--nonsense").exit_code, 2);
  EXPECT_EQ(run("a b c").exit_code, 2);
  EXPECT_EQ(run("a b --unit parsec").exit_code, 2);
}

TEST_F(Program, control_characters_in_what_it_reads_are_written_out) {
  const std::string red = "\x1b[31m";
  folder.write(red + "bad.sonde.json", R"({"pro\u001b[31mbe": 1})");
  for (const std::string& arguments :
       {"'" + red + "none.sonde.json' --screenshot x.png",
        "'" + red + "bad.sonde.json' --screenshot x.png", "--device '" + red + "'",
        "a b --unit '" + red + "'", "'" + red + ".off' b --screenshot x.png"}) {
    const Outcome refused = run(arguments);
    EXPECT_THAT(refused.err, HasSubstr("\\x1b[31m")) << arguments;
    EXPECT_EQ(refused.err.find('\x1b'), std::string::npos) << arguments;
  }
}

TEST_F(Program, a_device_that_nothing_is_called_is_wrong_usage) {
  const Outcome unknown = run("--device sigma7");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("\"sigma7\"; the nearest known one is \"sigma.7\""));
  EXPECT_EQ(run("--device ''").exit_code, 2);
}

TEST_F(Program, a_device_that_cannot_be_used_is_bad_input) {
  const Outcome absent = run("--device /dev/hidraw99");
  EXPECT_EQ(absent.exit_code, 3);
  EXPECT_THAT(absent.err, HasSubstr("/dev/hidraw99: no 6-DoF device is connected there"));
  const Outcome missing = run("--device none.json");
  EXPECT_EQ(missing.exit_code, 3);
  EXPECT_THAT(missing.err, HasSubstr("none.json"));
  folder.write("bad.json", "{\n\"nam\": 1}");
  const Outcome bad = run("--device bad.json");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_THAT(bad.err, HasSubstr("bad.json:2: "));
}

TEST_F(Program, a_simulated_device_and_auto_open_a_window) {
  for (const char* device : {"sigma.7", "auto", "mouse"}) {
    const Outcome shown = run(std::string("--screenshot shown.png --device ") + device);
    EXPECT_EQ(shown.exit_code, 0) << device << ": " << shown.err;
    EXPECT_TRUE(std::filesystem::remove(folder / "shown.png")) << device;
  }
}

/// A server of its own, which is killed under the window.
TEST_F(Program, a_display_that_is_lost_ends_it_with_a_word) {
  const std::string script =
      "cd '" + folder.path().string() + "' && { " +
      R"(Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp 3>number 2>log & server=$!
         until [ -s number ]; do sleep 0.1; done
         DISPLAY=:$(cat number) XDG_CONFIG_HOME=. timeout 60 ')" SONDE_VIEW_PROGRAM
      R"(' >out 2>err & window=$!
         sleep 4; kill -9 $server; wait $window; })";
  const int status = std::system(script.c_str());
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1) << "124: it hung; above 128: a signal ended it";
  EXPECT_THAT(sonde::test::text_of(folder / "err"), HasSubstr("connection broke"));
}

TEST_F(Program, a_home_that_takes_nothing_is_not_needed) {
  const Outcome shown = run("--screenshot shown.png",
                            "HOME=/proc XDG_CONFIG_HOME=/proc XDG_CACHE_HOME=/proc "
                            "XDG_DATA_HOME=/proc XDG_RUNTIME_DIR=/proc");
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_FALSE(QImage(QString::fromStdString((folder / "shown.png").string())).isNull());
}

/// The settings that the window keeps, as a disk or a stranger's hand may leave them.
TEST_F(Program, settings_that_are_damaged_do_not_keep_it_from_opening) {
  const std::string nulls(300, '\0');
  const std::string cases[] = {
      "rubbish without end",
      nulls,
      "\xff\xfe[General\n=\n[[[]\ntheme",
      "[General]\ngeometry=@ByteArray(\\x1\\xd9\\xd0\\xcb\\xff\\xff\\xff\\xff\\xff\\xff)\n"
      "docks=@ByteArray(\\0\\0\\0\\xff\\xff\\xff\\xff\\xff\\xff)\ntheme=-99999999999999999999\n",
      "[General]\ngeometry=@Variant(\\0\\0\\0\\x7f)\ndocks=7\ntheme=@Point(1 2)\nrecent=@Size(1 "
      "1)\n"
      "last_folder=@Invalid()\n",
      "[General]\ntheme=99\nrecent=\\x1, , /no/such/scene.sonde.json, \"\"\n",
  };
  std::filesystem::create_directories(folder / "sonde");
  for (const std::string& text : cases) {
    folder.write("sonde/sonde-view.conf", text);
    const Outcome shown = run("--screenshot shown.png");
    EXPECT_EQ(shown.exit_code, 0) << text << ": " << shown.err;
    EXPECT_GT(lit_share(QImage(QString::fromStdString((folder / "shown.png").string()))), 0.05)
        << text;
    std::filesystem::remove(folder / "shown.png");
  }
  std::filesystem::remove_all(folder / "sonde/sonde-view.conf");
  std::filesystem::create_directories(folder / "sonde/sonde-view.conf");
  EXPECT_EQ(run("--screenshot shown.png").exit_code, 0) << "a folder of that name";
}

TEST_F(Program, no_display_is_said) {
  const Outcome none = run("", "DISPLAY= WAYLAND_DISPLAY=");
  EXPECT_EQ(none.exit_code, 4);
  EXPECT_THAT(none.err, HasSubstr("DISPLAY"));
  EXPECT_EQ(run("", "DISPLAY=:94123").exit_code, 4) << "one that does not answer";
  const Outcome blind = run("", "QT_QPA_PLATFORM=offscreen");
  EXPECT_EQ(blind.exit_code, 4);
  EXPECT_THAT(blind.err, HasSubstr("QT_QPA_PLATFORM"));
}

TEST_F(Program, a_bad_file_is_3) {
  folder.write("bad.sonde.json", "{");
  const Outcome bad = run("bad.sonde.json --screenshot none.png");
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_THAT(bad.err, HasSubstr("bad.sonde.json"));
  EXPECT_EQ(run("no-such.off no-such.off --unit mm --screenshot none.png").exit_code, 3);
  EXPECT_EQ(run("no-such.stl --screenshot none.png").exit_code, 3);
  EXPECT_FALSE(std::filesystem::exists(folder / "none.png"));
}

/// Nobody who has double-clicked a file sees stderr: the window stays, and says it.
TEST_F(Program, a_bad_file_to_look_at_leaves_a_window_that_says_why) {
  folder.write("broken.stl", "PK\x03\x04 is no mesh");
  const std::string command =
      "cd '" + folder.path().string() +
      "' && { XDG_CONFIG_HOME=. XDG_DATA_HOME=. XDG_CACHE_HOME=. timeout 60 '" SONDE_VIEW_PROGRAM
      "' broken.stl >out 2>err & p=$!; for i in $(seq 500); do grep -q broken.stl err && break; "
      "sleep 0.1; done; sleep 1; kill -0 $p 2>/dev/null && echo yes >alive; kill $p; wait $p; }";
  ASSERT_NE(std::system(command.c_str()), -1);
  EXPECT_THAT(sonde::test::text_of(folder / "err"), HasSubstr("broken.stl: is not an STL file"));
  EXPECT_EQ(sonde::test::text_of(folder / "alive"), "yes\n");
}

TEST_F(Program, the_demo_draws_and_reports) {
  const Outcome demo = run("--demo demo.png");
  EXPECT_EQ(demo.exit_code, 0) << demo.err;
  EXPECT_THAT(demo.out, HasSubstr("demo.png"));
  for (const char* quantity : {"depth", "PD_t", "lower bound", "|F|", "|tau|", "tick", "frames/s"})
    EXPECT_THAT(demo.out, HasSubstr(quantity));
  const QImage image(QString::fromStdString((folder / "demo.png").string()));
  EXPECT_GT(lit_share(image), 0.05);
  // The deepest pose of the path as a run tick by tick has it, whatever the display does meanwhile:
  // the same picture again, beside a machine that is busy.
  const auto depth_of = [](const std::string& out) {
    return out.substr(out.find("depth held"), out.find(", |F|") - out.find("depth held"));
  };
  EXPECT_THAT(demo.out, Not(HasSubstr("depth held 0 m")));
  const Outcome again = run("--demo again.png", "LP_NUM_THREADS=1");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(depth_of(demo.out), depth_of(again.out));
  EXPECT_EQ(pixels_between(image, QImage(QString::fromStdString((folder / "again.png").string()))),
            0);
}

}  // namespace
}  // namespace sonde::ui::test
