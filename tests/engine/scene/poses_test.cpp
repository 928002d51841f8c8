// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/poses.hpp"

#include <gmock/gmock.h>

#include <clocale>
#include <cstdlib>

#include "engine/base/error.hpp"
#include "tests/support/complaint.hpp"
#include "tests/support/locales.hpp"

namespace sonde {
namespace {

using test::TempFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string header = "px,py,pz,qw,qx,qy,qz\n";
const std::string timed_header = "t,px,py,pz,qw,qx,qy,qz\n";

std::vector<Pose> poses_of(const std::string& text) {
  const TempFolder folder;
  return read_poses(folder.write("p.csv", text));
}

std::string poses_complaint(const std::string& text) {
  return test::complaint_of(text, "p.csv", read_poses);
}
std::string timed_complaint(const std::string& text) {
  return test::complaint_of(text, "p.csv", read_trajectory);
}

TEST(Poses, rows_are_read_to_the_bit) {
  const auto poses = poses_of(header + "0.1,-2e-3,3,1,0,0,0\n+1,.5,1e300,0,0,0,-1\n");
  ASSERT_EQ(poses.size(), 2u);
  EXPECT_EQ(poses[0].p, Vec3(0.1, -2e-3, 3));
  EXPECT_EQ(poses[0].q.w(), 1);
  EXPECT_EQ(poses[1].p, Vec3(1, 0.5, 1e300));
  EXPECT_EQ(poses[1].q.z(), -1);
}

TEST(Poses, line_ends_of_every_kind_blank_lines_at_the_end_and_a_byte_order_mark_are_accepted) {
  const std::string row = "0,0,0,1,0,0,0";
  for (const char* end : {"", "\n", "\n\n\n", "\r\n", "\r\n\r\n", "\n  \n"})
    EXPECT_EQ(poses_of(header + row + end).size(), 1u);
  EXPECT_EQ(poses_of("px,py,pz,qw,qx,qy,qz\r\n" + row + "\r\n" + row + "\r\n").size(), 2u);
  EXPECT_EQ(poses_of("\xEF\xBB\xBF" + header + row).size(), 1u);
}

TEST(Poses, no_rows_are_no_poses) {
  EXPECT_TRUE(poses_of(header).empty());
  EXPECT_TRUE(poses_of("px,py,pz,qw,qx,qy,qz").empty());
}

TEST(Poses, a_wrong_header_says_what_was_expected) {
  EXPECT_THAT(poses_complaint("x,y,z,qw,qx,qy,qz\n"),
              AllOf(StartsWith("1: "), HasSubstr("x,y,z,qw"), HasSubstr("px,py,pz,qw,qx,qy,qz")));
  EXPECT_THAT(poses_complaint("0,0,0,1,0,0,0\n"), StartsWith("1: "));
  EXPECT_THAT(poses_complaint(timed_header), StartsWith("1: ")) << "a trajectory";
  EXPECT_THAT(timed_complaint(header), HasSubstr("expected \"t,px")) << "poses";
  EXPECT_THAT(poses_complaint("\n" + header), StartsWith("1: "));
}

TEST(Poses, wrong_rows_are_named_by_their_line) {
  const std::string good = header + "0,0,0,1,0,0,0\n";
  EXPECT_THAT(poses_complaint(good + "0,0,0,1,0,0\n"), StartsWith("3: 6 columns; expected 7"));
  EXPECT_THAT(poses_complaint(good + "0,0,0,1,0,0,0,0\n"), StartsWith("3: 8 columns; expected 7"));
  EXPECT_THAT(poses_complaint(good + "0,0,0,1,0,0,0,\n"), StartsWith("3: 8 columns"));
  EXPECT_THAT(poses_complaint(good + "\n0,0,0,1,0,0,0\n"), StartsWith("3: a blank line"));
  for (const char* field : {"", "x", "1x", "nan", "inf", "-inf", "1e999", "0x10", " 1", "1 ", "1;5",
                            "--1", "+-1", "1e", "\"1\""}) {
    EXPECT_THAT(poses_complaint(good + "0," + field + ",0,1,0,0,0\n"),
                AllOf(StartsWith("3: py is \""), HasSubstr("not a finite number")))
        << field;
  }
}

TEST(Poses, quaternions_far_from_unit_are_refused_and_others_normalised) {
  EXPECT_THAT(poses_complaint(header + "0,0,0,1.0011,0,0,0\n"),
              AllOf(StartsWith("2: "), HasSubstr("1.0011")));
  EXPECT_THAT(poses_complaint(header + "0,0,0,0,0,0,0\n"), HasSubstr("length 0"));
  EXPECT_THAT(poses_complaint(header + "0,0,0,1e200,0,0,0\n"), StartsWith("2: "));
  EXPECT_NEAR(poses_of(header + "0,0,0,0.6005,0.8005,0,0\n")[0].q.norm(), 1, 1e-15);
}

TEST(Poses, a_file_that_is_not_there_or_empty_is_refused) {
  const TempFolder folder;
  EXPECT_THROW(read_poses(folder / "none.csv"), InputError);
  EXPECT_THROW(read_poses(folder.path()), InputError);
  EXPECT_THAT(poses_complaint(""), HasSubstr("empty"));
}

TEST(Poses, the_locale_does_not_matter) {
  const TempFolder folder;
  ::setenv("LOCPATH", make_locale(folder, "de_DE").c_str(), 1);
  ASSERT_TRUE(std::setlocale(LC_ALL, "de_DE.UTF-8"));
  ASSERT_EQ(std::strtod("0,5", nullptr), 0.5) << "the comma is decimal";
  EXPECT_EQ(poses_of(header + "0.5,0,0,1,0,0,0\n")[0].p.x(), 0.5);
  std::setlocale(LC_ALL, "C");
  ::unsetenv("LOCPATH");
}

TEST(Trajectory, times_must_rise) {
  const TempFolder folder;
  const auto path = read_trajectory(
      folder.write("t.csv", timed_header + "-1,0,0,0,1,0,0,0\n0.001,1,0,0,1,0,0,0\n"));
  ASSERT_EQ(path.size(), 2u);
  EXPECT_EQ(path[0].t, -1);
  EXPECT_EQ(path[1].t, 0.001);
  EXPECT_EQ(path[1].pose.p.x(), 1);
  EXPECT_THAT(timed_complaint(timed_header + "1,0,0,0,1,0,0,0\n1,0,0,0,1,0,0,0\n"),
              AllOf(StartsWith("3: "), HasSubstr("t must rise")));
  EXPECT_THAT(timed_complaint(timed_header + "1,0,0,0,1,0,0\n"), StartsWith("2: 7 columns"));
  EXPECT_THAT(timed_complaint(timed_header + "a,0,0,0,1,0,0,0\n"), StartsWith("2: t is \"a\""));
}

}  // namespace
}  // namespace sonde
