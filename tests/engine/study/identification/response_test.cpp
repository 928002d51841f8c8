// SPDX-License-Identifier: GPL-3.0-or-later
// References: lines written out here.
#include "engine/study/identification/response.hpp"

#include <gmock/gmock.h>

#include "tests/support/complaint.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string header = "t,fx,fy,fz,tx,ty,tz,px,py,pz,qw,qx,qy,qz\n";

TEST(Response, is_read_as_it_is_written_to_the_bit) {
  Response out;
  for (int i = 0; i < 3; ++i)
    out.push_back({0.1 * i + 1.0 / 3,
                   {.force = {0.1, -i / 7.0, 3}, .torque = {1e-9, 0, 0.3}},
                   {Quat(0.6, 0.8, 0, 0), {0.1, 1.0 / 3, -1e-7}}});
  const test::TempFolder folder;
  const Response in = read_response(folder.write("r.csv", response_text(out)));
  ASSERT_EQ(in.size(), out.size());
  for (std::size_t i = 0; i < in.size(); ++i) {
    EXPECT_EQ(in[i].t, out[i].t);
    EXPECT_EQ(in[i].command.force, out[i].command.force);
    EXPECT_EQ(in[i].command.torque, out[i].command.torque);
    EXPECT_EQ(in[i].X_BH.p, out[i].X_BH.p);
    EXPECT_EQ(in[i].X_BH.q.coeffs(), out[i].X_BH.q.coeffs());
  }
}

std::string reading_complaint(const std::string& text) {
  return test::complaint_of(text, "r.csv", read_response);
}

TEST(Response, bad_lines_are_named_with_their_reason) {
  const std::string row = "0,1,0,0,0,0,0,0,0,0,1,0,0,0\n";
  EXPECT_EQ(reading_complaint(header + row), "");
  EXPECT_THAT(reading_complaint("t,px,py,pz,qw,qx,qy,qz\n"),
              AllOf(StartsWith("1: "), HasSubstr("t,fx,fy")));
  EXPECT_THAT(reading_complaint(header + row + row),
              AllOf(StartsWith("3: "), HasSubstr("t must rise from row to row")));
  EXPECT_THAT(reading_complaint(header + "0,1,0,0,0,0,0,0,0,0,1,0,0\n"),
              AllOf(StartsWith("2: "), HasSubstr("13 columns; expected 14")));
  EXPECT_THAT(reading_complaint(header + "0,1,0,x,0,0,0,0,0,0,1,0,0,0\n"),
              AllOf(StartsWith("2: "), HasSubstr("fz is \"x\"")));
  EXPECT_THAT(reading_complaint(header + "0,inf,0,0,0,0,0,0,0,0,1,0,0,0\n"), HasSubstr("finite"));
  EXPECT_THAT(reading_complaint(header + "0,1,0,0,0,0,0,0,0,0,2,0,0,0\n"),
              AllOf(StartsWith("2: "), HasSubstr("quaternion")));
}

}  // namespace
}  // namespace sonde
