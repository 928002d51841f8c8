// SPDX-License-Identifier: GPL-3.0-or-later
// Renderings made up by hand: what they come to is known.
#include "engine/study/comparison/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "engine/base/error.hpp"
#include "engine/study/comparison/compare_report.hpp"
#include "tests/support/xml.hpp"

namespace sonde {
namespace {

/// A press to `force` N and back within two seconds, at 1 kHz, trembling by `trembling` N at 200
/// Hz.
Rendering press(double force, double trembling) {
  Rendering out;
  for (int i = 0; i <= 2000; ++i) {
    RenderedTick tick;
    tick.t = 0.001 * i;
    tick.moved = 1e-4;
    const double x = std::pow(std::sin(std::numbers::pi * i / 2000), 2);
    tick.force.z() = force * x + trembling * x * std::sin(2 * std::numbers::pi * 0.2 * i);
    tick.depth = tick.force.norm() / 500;
    out.push_back(tick);
  }
  return out;
}

StudyFolder folder_of(const Rendering& pdt, const Rendering& pdg) {
  return {"compare",
          R"({"scene": "a scene", "stiffness": 500, "radius": 0.05,
              "coupling": {"max_force": 2.5, "max_torque": 1}})",
          {"pdt", "pdg", "analytic"},
          {to_json(pdt), to_json(pdg), to_json(AnalyticWrenches())}};
}

TEST(Compare, measures_are_those_of_the_renderings) {
  const Comparison c = comparison_of("folder", folder_of(press(3, 0), press(2, 0)));
  EXPECT_EQ(c.scene, "a scene");
  EXPECT_NEAR(c.of_pdt.peak_force, 3, 1e-9);
  EXPECT_NEAR(c.of_pdt.force_variation, 6, 1e-9) << "up and down";
  EXPECT_NEAR(c.of_pdg.force_restlessness(), 2, 1e-9);
  EXPECT_EQ(c.of_pdg.saturated_ticks, 0);
  EXPECT_GT(c.of_pdt.saturated_ticks, 100);
  EXPECT_EQ(c.of_pdt.contact_ticks, 2000) << "all but the first; the last is zero but for rounding";
  EXPECT_LT(*c.of_pdt.force_above_50, 1e-6);
  EXPECT_FALSE(c.of_pdt.torque_above_50) << "there is no torque";
}

// By its size alone its total variation is a third, and the share of it that trembles the same.
TEST(Compare, nothing_is_said_for_a_force_that_is_only_smaller) {
  for (const auto& [pdt, pdg] : {std::pair(6.0, 2.0), std::pair(2.0, 6.0)})
    for (const StudyFile& file :
         compare_files("folder", folder_of(press(pdt, 0.01 * pdt), press(pdg, 0.01 * pdg)))) {
      if (file.name != "summary.json") continue;
      for (const auto& [key, finding] : nlohmann::json::parse(file.text).at("pdg_claims").items())
        EXPECT_EQ(finding, key.starts_with("smoother") ? "undecided" : "none")
            << key << ' ' << pdt << ' ' << pdg;
    }
}

TEST(Compare, a_path_with_gaps_is_said_to_have_them) {
  Rendering whole = press(3, 0), gapped = whole;
  gapped.erase(gapped.begin() + 500, gapped.begin() + 899);
  const auto summary = [](const Rendering& r) {
    for (const StudyFile& file : compare_files("folder", folder_of(r, r)))
      if (file.name == "summary.md") return file.text;
    return std::string();
  };
  EXPECT_EQ(summary(whole).find("evenly sampled"), std::string::npos);
  EXPECT_NE(summary(gapped).find("up to 0.4 s lie between two rows"), std::string::npos);
}

TEST(Compare, parts_that_are_missing_or_wrong_are_named) {
  StudyFolder folder = folder_of(press(1, 0), press(1, 0));
  folder.results[1].reset();
  EXPECT_THROW(comparison_of("folder", folder), InputError);
  folder.results[1] = "{}";
  EXPECT_THROW(comparison_of("folder", folder), InputError);
  folder = folder_of(press(1, 0), press(1, 0));
  folder.about = "{}";
  EXPECT_THROW(comparison_of("folder", folder), InputError);
}

TEST(Compare, the_picture_has_both_curves_in_every_panel) {
  const auto files = compare_files("folder", folder_of(press(3, 0), press(2, 0)));
  ASSERT_EQ(files.size(), 6u);
  for (const StudyFile& file : files) {
    if (!file.name.ends_with(".svg")) continue;
    const test::Xml svg = test::parse_xml(file.text);
    for (const test::Xml* panel : svg.all("g", "panel")) {
      std::size_t lines = 0;
      for (const test::Xml* series : panel->all("g", "series"))
        lines += !series->all("polyline").empty();
      // No torque has no logarithm.
      EXPECT_EQ(lines,
                file.name == "wrench.svg" || panel == svg.all("g", "panel").front() ? 2u : 0u);
    }
  }
}

}  // namespace
}  // namespace sonde
