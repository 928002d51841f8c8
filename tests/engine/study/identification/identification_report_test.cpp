// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/identification_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/engine/study/identification/bundled_profiles.hpp"
#include "tests/engine/study/identification/made_up_identification.hpp"

namespace sonde {
namespace {

using test::assumed_profile;
using test::made_up_identification;
using testing::HasSubstr;

TEST(IdentificationReport, has_each_figure_with_its_interval_beside_the_profiles_and_a_unit) {
  DeviceProfile profile = assumed_profile();
  profile.mass.value = 0.37;
  const std::string text = identification_text(made_up_identification(), profile);
  EXPECT_THAT(text, testing::ContainsRegex("mass +0.25 +0.24 +0.26 +0.37 +kg\n"));
  EXPECT_THAT(text, testing::ContainsRegex("delay +0.002 +0.0019 +0.0021 +[0-9.]+ +s\n"));
  EXPECT_THAT(text, testing::Not(HasSubstr("inertia"))) << "no rotation was measured";
}

TEST(IdentificationReport, says_what_each_axis_rests_on_or_why_it_was_refused) {
  Identification found = made_up_identification();
  EXPECT_THAT(identification_text(found, assumed_profile()),
              HasSubstr("force along y: 16 pulses of up to 2 N; 3.4 % of the motion is "
                        "unexplained\ntorque about y: not identified: it did not move\n"));
  found.axes[0].has_steps = false;
  EXPECT_THAT(identification_text(found, assumed_profile()),
              HasSubstr("unexplained; no step of the encoder was seen: it may be as large"));
}

TEST(IdentificationReport, columns_are_aligned_by_characters) {
  Identification found = made_up_identification();
  found.rotation = IdentifiedKind{{2e-4, 1e-4, 3e-4}, {0.01, 0, 0.02}, {0.001, 0, 0.002}, {}};
  const std::string text = identification_text(found, assumed_profile());
  std::string header, mass, inertia;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (header.empty()) header = line;
    if (line.starts_with("mass")) mass = line;
    if (line.starts_with("inertia")) inertia = line;
  }
  ASSERT_NE(header.find("unit"), std::string::npos);
  EXPECT_EQ(mass.substr(header.find("unit")), "kg");
  EXPECT_EQ(inertia.substr(header.find("unit")), "kg·m²");
}

TEST(IdentificationReport, as_json_it_holds_the_same) {
  DeviceProfile profile = assumed_profile();
  const auto json = nlohmann::json::parse(identification_json(made_up_identification(), profile));
  const auto& mass = json.at("values").at("mass");
  EXPECT_EQ(mass.at("value"), 0.25);
  EXPECT_EQ(mass.at("low"), 0.24);
  EXPECT_EQ(mass.at("high"), 0.26);
  EXPECT_EQ(mass.at("unit"), "kg");
  EXPECT_EQ(mass.at("profile"), profile.mass.value);
  EXPECT_FALSE(json.at("values").contains("inertia"));
  EXPECT_EQ(json.at("sample_time"), 1e-3);
  EXPECT_EQ(json.at("axes").at(0).at("axis"), "force along y");
  EXPECT_EQ(json.at("axes").at(0).at("friction").at("high"), 0.15);
  EXPECT_EQ(json.at("axes").at(0).at("steps_seen"), true);
  EXPECT_EQ(json.at("not_identified").at(0).at("reason"), "it did not move");
}

}  // namespace
}  // namespace sonde
