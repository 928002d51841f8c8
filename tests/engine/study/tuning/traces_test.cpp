// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/traces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/study/tuning/traces_report.hpp"
#include "tests/engine/study/never.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/xml.hpp"

namespace sonde {
namespace {

using test::never;
using testing::ElementsAre;
using testing::HasSubstr;

/// A small box pressed on a large one.
TracesRequest traces_of_boxes(Coupling::Mode mode) {
  TuningRequest tuning{
      .pair = {test::body(test::box({0.06, 0.05, 0.04})), test::body(test::box({0.2, 0.2, 0.1}))}};
  tuning.X_FM = {Quat::Identity(), {0, 0, 0.1}};
  tuning.coupling.mode = mode;
  tuning.device = read_device_profile(SONDE_RESOURCES "/devices/sigma.7.json");
  for (int i = 0; i < 30; ++i)
    tuning.path.push_back({i * 1e-3, {Quat::Identity(), {0.01, 0.005, 0.075 - i * 2e-4}}});
  return {.tuning = tuning, .stiffness = {200, 300}};
}

std::vector<std::string> names(const std::vector<StudyFile>& files) {
  std::vector<std::string> out;
  for (const StudyFile& file : files) out.push_back(file.name);
  return out;
}

TEST(Traces, of_the_object_norm_are_one_picture_of_stiffness_by_course) {
  const test::TempFolder folder;
  compute_parts(folder.path(), plan_traces(traces_of_boxes(Coupling::Mode::object), never), {}, 2,
                never);
  const auto files = traces_files(folder.path().string(), read_study(folder.path()));
  ASSERT_THAT(names(files), ElementsAre("traces.csv", "summary.csv", "summary.md", "traces.svg"));
  EXPECT_EQ(test::parse_xml(files[3].text).all("g", "cell").size(), 2u * 4);
  const auto lines = std::ranges::count(files[0].text, '\n');
  EXPECT_EQ(lines, 1 + 2 * 4 * 1200);
  EXPECT_THAT(files[0].text, HasSubstr("course,k,b,t,fx,fy,fz,tx,ty,tz,depth\nstep,200,0,0,"));
  EXPECT_EQ(std::ranges::count(files[1].text, '\n'), 1 + 2 * 4);
}

TEST(Traces, of_the_classic_coupling_are_one_picture_of_all_and_one_for_each_course) {
  TracesRequest request = traces_of_boxes(Coupling::Mode::classic);
  request.damping = {0, 5};
  const test::TempFolder folder;
  compute_parts(folder.path(), plan_traces(request, never), {}, 2, never);
  const auto files = traces_files(folder.path().string(), read_study(folder.path()));
  ASSERT_THAT(names(files), ElementsAre("traces.csv", "summary.csv", "summary.md", "traces.svg",
                                        "traces-step.svg", "traces-ramp.svg", "traces-slide.svg",
                                        "traces-reversal.svg"));
  EXPECT_EQ(test::parse_xml(files[3].text).all("g", "cell").size(), 2u * 4 * 2);
  EXPECT_THAT(files[3].text, HasSubstr("reversal, b = 5 N·s/m"));
  for (std::size_t course = 0; course < 4; ++course)
    EXPECT_EQ(test::parse_xml(files[4 + course].text).all("g", "cell").size(), 2u * 2);
}

/// Reference: theory, whose limit the study names in the same place.
TEST(Traces, without_a_stiffness_they_are_at_shares_of_what_theory_allows) {
  TracesRequest request = traces_of_boxes(Coupling::Mode::object);
  request.stiffness.clear();
  const auto about = nlohmann::json::parse(plan_traces(request, never).about);
  const double theory = about.at("theory_stable");
  const auto k = about.at("stiffness").get<std::vector<double>>();
  ASSERT_EQ(k.size(), 4u);
  const double shares[] = {0.25, 0.5, 1, 1.5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(k[i], shares[i] * theory, 0.006 * k[i]);
}

TEST(Traces, in_shards_they_are_the_same_bits) {
  const TracesRequest request = traces_of_boxes(Coupling::Mode::object);
  const test::TempFolder whole, shards;
  compute_parts(whole.path(), plan_traces(request, never), {}, 1, never);
  for (const std::size_t i : {1u, 0u})
    compute_parts(shards.path(), plan_traces(request, never), {i, 2}, 2, never);
  const auto a = traces_files("a", read_study(whole.path()));
  const auto b = traces_files("b", read_study(shards.path()));
  ASSERT_EQ(names(a), names(b));
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].text, b[i].text) << a[i].name;
}

TEST(Traces, what_is_not_there_is_said) {
  TracesRequest request = traces_of_boxes(Coupling::Mode::object);
  request.kind = ContactKind::jammed;
  EXPECT_THROW(plan_traces(request, never), InputError);
  StudyFolder cut{.kind = "traces", .about = "{}", .names = {"step.k0.b0"}, .results = {{}}};
  EXPECT_THROW(traces_files("folder", cut), InputError);
  cut.results = {"{\"course\": \"step\"}"};
  EXPECT_THROW(traces_files("folder", cut), InputError);
}

}  // namespace
}  // namespace sonde
