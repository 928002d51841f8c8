// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/recommendation_text.hpp"

#include <gtest/gtest.h>

#include <QStringList>

#include "engine/study/tuning/tuning_words.hpp"
#include "tests/engine/study/tuning/made_up_results.hpp"

namespace sonde::ui {
namespace {

using sonde::test::column;
using sonde::test::line;

TuningLine assumed(const char* key, double times, double stable) {
  TuningLine out = line(1, GainAxis::object, {column(0, stable)});
  out.assumed = key;
  out.times = times;
  return out;
}

TEST(RecommendationText, names_values_margin_reason_and_what_it_rests_on) {
  TuningResults r = sonde::test::results();
  r.lines = {line(0, GainAxis::object, {column(0, 1500)}),
             line(1, GainAxis::object, {column(0, 900)}),
             assumed("mass", 0.5, 450),
             assumed("mass", 2, 1800),
             assumed("friction", 0.5, 901),
             assumed("friction", 2, 899)};
  const std::string text = recommendation_text(r, GainAxis::object).toStdString();
  for (const char* words :
       {"Recommended: k 600 N/m, limited by stability (edge contact, light hand).",
        "900 N/m (a margin of 1.5)", "passive in theory up to 225 N/m", "mass 0.5 to 2 times",
        "hardly on the friction"})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  const std::string limit =
      "the study allows 600 N/m, limited by stability (edge contact, light hand): ";
  EXPECT_EQ(margin_text(r, GainAxis::object, 300, 0).toStdString(),
            limit + "could be 2.00 times as stiff");
  EXPECT_EQ(margin_text(r, GainAxis::object, 42'180, 0).toStdString(),
            limit + "70.3 times too stiff");
}

TEST(RecommendationText, names_what_friction_carries_and_the_assumption_that_limits) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 1500)}), assumed("mass", 0.5, 450),
             assumed("mass", 2, 1800)};
  r.lines[0].columns[0].without_friction = {300, HoldFault::unstable};
  r.lines[0].columns[0].harder_knocks = {600, HoldFault::unstable};
  const std::string text = recommendation_text(r, GainAxis::object).toStdString();
  for (const char* words :
       {"k 200 N/m, limited by stability without friction", "without friction up to 300 N/m",
        "at harder knocks up to 600 N/m",
        "Of the device's values that are not sure, the mass limits most: by the limits of the edge "
        "contact (light hand) alone, 200 N/m as it is, 300 N/m at 0.1 kg, 1200 N/m at 0.4 kg."})
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
}

// What a handle bears without a hand, and what rests, count too, though no sweep looks at either.
TEST(RecommendationText, at_the_recommended_gains_nothing_stiffer_is_said_to_do) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 9000)})};
  r.lines[0].columns[0].theory_released = 450;
  EXPECT_EQ(margin_text(r, GainAxis::object, 300, 0),
            "the study allows 300 N/m, limited by what the handle bears once no hand holds it, in "
            "theory (edge contact): as stiff as it may be");
  r.ladder = RestLadder{
      GainAxis::object, 0, {{300, Swing{"edge", "limp", 0, 4, 2e-3, 31, 700}, 4}, {150, {}, 2}}};
  EXPECT_TRUE(recommendation_text(r, GainAxis::object).contains("Recommended: k 150 N/m"));
  EXPECT_EQ(margin_text(r, GainAxis::object, 300, 0),
            "the study allows 150 N/m, limited by what comes to rest (edge contact, limp hand): "
            "2.00 times too stiff");
}

TEST(RecommendationText, says_as_the_terminal_why_none_is_passive_and_what_would_help) {
  TuningResults r = sonde::test::results();
  r.mode = Coupling::Mode::damped;
  r.lines = {line(1, GainAxis::damped, {column(2, 1500)})};
  r.lines[0].columns[0].theory_passive = 0;
  const QString damped = recommendation_text(r, GainAxis::damped);
  EXPECT_TRUE(
      damped.contains("\nNo stiffness is passive at this damping, which is more than the "
                      "device's own: "))
      << damped.toStdString();
  EXPECT_FALSE(damped.contains("gradient"));
  r.ladder =
      RestLadder{GainAxis::damped, 2, {{900, Swing{"edge", "limp", 0, 4, 2e-3, 31, 700}, 4}}};
  const QString none = recommendation_text(r, GainAxis::damped);
  EXPECT_TRUE(none.contains("\nAt no stiffness tried did it come to rest everywhere: "))
      << none.toStdString();
  EXPECT_TRUE(none.contains("\nWhat would help: "));
}

TEST(RecommendationText, says_where_the_gains_rely_on_friction) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 1500)})};
  EXPECT_FALSE(recommendation_text(r, GainAxis::object).contains("rely on friction"));
  r.lines[0].columns[0].without_friction = {1200, HoldFault::unstable};
  r.lines[0].columns[0].long_hold = {900, true, false};
  EXPECT_TRUE(recommendation_text(r, GainAxis::object)
                  .contains("These gains may rely on friction: without it, at 900 N/m, the probe "
                            "swings on in the edge contact (light hand)."));
  r.device["friction"] = r.device["rotational_friction"] = 0;
  EXPECT_TRUE(recommendation_text(r, GainAxis::object)
                  .contains("The device has no friction: at 900 N/m, the probe swings on"));
}

TEST(RecommendationText, says_where_a_hard_knock_swings_on) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 1500)})};
  EXPECT_FALSE(recommendation_text(r, GainAxis::object).contains("After a knock"));
  r.lines[0].columns[0].long_hold.reset();
  EXPECT_TRUE(recommendation_text(r, GainAxis::object).contains("was not looked at"));
  r.lines[0].columns[0].long_hold = {900, false, true};
  EXPECT_TRUE(
      recommendation_text(r, GainAxis::object)
          .contains("After a knock of 4 times the strength, at 900 N/m, the probe swings on "
                    "in the edge contact (light hand)."));
  r.lines[0].columns[0].long_hold = {900, false, false};
  EXPECT_FALSE(recommendation_text(r, GainAxis::object).contains("swings on"));
  EXPECT_TRUE(recommendation_text(r, GainAxis::object)
                  .contains("Held for seconds at 900 N/m, once without friction and once after a "
                            "knock of 4 times the strength, the probe comes to rest."));
  r.lines[0].columns[0].long_hold = {90, false, false};
  EXPECT_TRUE(recommendation_text(r, GainAxis::object).contains("at 90 N/m, far from these gains"));
}

TEST(RecommendationText, says_where_the_boundary_without_friction_is_theorys) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 1500)})};
  TuningColumn& only = r.lines[0].columns[0];
  only.without_friction = {1200, HoldFault::unstable};
  EXPECT_TRUE(recommendation_text(r, GainAxis::object).contains("without friction up to 1200 N/m"))
      << recommendation_text(r, GainAxis::object).toStdString();
  only.without_friction->stiffness = 1100;
  only.without_friction_by_theory = true;
  EXPECT_TRUE(recommendation_text(r, GainAxis::object)
                  .contains("without friction, in theory, up to 1100 N/m"));
}

TEST(RecommendationText, says_what_the_handle_does_without_a_hand) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 1500)})};
  const auto says = [&](double released, double any_swing, const char* words) {
    r.lines[0].columns[0].theory_released = released;
    r.lines[0].columns[0].theory_released_any_swing = any_swing;
    const QString text = recommendation_text(r, GainAxis::object);
    EXPECT_TRUE(text.contains(words)) << text.toStdString();
  };
  says(4500, 4500,
       "\nIf the hand lets go, no swing of the handle grows: in theory it may be up to 4500 N/m.");
  // A slow swing that grows caps what is recommended, unless the hand is said never to let go.
  says(4500, 23.4,
       "\nIf the hand lets go, no swing of the handle grows: in theory it may be up to 23.4 N/m.");
  r.always_held = true;
  says(4500, 23.4,
       "\nIf the hand lets go, the handle is unstable: in theory a swing slower than 5 Hz grows "
       "from 23.4 N/m on");
  says(450, 300,
       "\nIf the hand lets go, the handle is unstable, and buzzes: in theory it may be up to 300 "
       "N/m; a hand that always holds was asked for.");
}

TEST(RecommendationText, says_why_no_damping_is_best) {
  TuningResults r = sonde::test::results();
  r.mode = Coupling::Mode::classic;
  r.lines = {
      line(0, GainAxis::together, {column(0, 900), column(5, 900, 300, HoldFault::chattering)})};
  EXPECT_TRUE(recommendation_text(r, GainAxis::together)
                  .contains("No virtual damping is best: at b_t 5 N·s/m the stiffness may be 300 "
                            "N/m, limited by chatter (flat contact, light hand)."));
  r.lines[0].columns[0].stable.stiffness = 150;
  EXPECT_FALSE(recommendation_text(r, GainAxis::together).contains("No virtual damping"));
}

TEST(RecommendationText, says_what_the_terminal_says_and_in_its_order) {
  TuningResults r = sonde::test::results();
  r.lines = {line(1, GainAxis::object, {column(0, 1500)}), assumed("mass", 0.5, 450),
             assumed("mass", 2, 1800)};
  r.lines[0].columns[0].theory_released = 4500;
  r.lines[0].columns[0].theory_released_any_swing = 4500;
  const std::vector<std::string> words = recommendation_in_words(r);
  const QStringList lines = recommendation_text(r, GainAxis::object).split('\n');
  ASSERT_EQ(std::size_t(lines.size()), words.size());
  for (int i = 0; i < lines.size(); ++i)
    EXPECT_TRUE(
        lines[i].endsWith(QString::fromStdString(words[std::size_t(i)]).mid(1) + QLatin1Char('.')))
        << lines[i].toStdString();
}

TEST(RecommendationText, another_reason_and_none_at_all) {
  TuningResults r = sonde::test::results();
  r.about = R"({"device": {"id": "x", "mass": {"value": 1, "assumed": "a guess"},
      "max_force": {"value": 9, "source": "a sheet"}}})";
  r.lines = {line(0, GainAxis::object, {column(0, 1500, 300, HoldFault::chattering)})};
  EXPECT_TRUE(recommendation_text(r, GainAxis::object)
                  .contains("It rests on assumed mass, which this study did not vary"));
  EXPECT_TRUE(recommendation_text(r, GainAxis::object).contains("limited by chatter"));
  r.lines = {line(0, GainAxis::object, {column(0, 1500, 0, HoldFault::saturated)})};
  EXPECT_TRUE(recommendation_text(r, GainAxis::object).contains("No stiffness"));
  r.lines.clear();
  EXPECT_TRUE(
      recommendation_text(r, GainAxis::object).contains("The study has no gains to recommend."));
}

TEST(RecommendationText, of_the_classic_coupling_all_four_gains_are_named_and_what_is_no_advice) {
  TuningResults r = sonde::test::results();
  r.mode = Coupling::Mode::classic;
  r.joint = {2e-4, 1e-3};
  r.lines = {line(0, GainAxis::together, {column(5, 900)}),
             line(0, GainAxis::translation, {column(0, 3000)})};
  const QString text = recommendation_text(r, GainAxis::together);
  for (const char* words :
       {"Recommended: k_t 600 N/m, k_r 0.12 N·m/rad, b_t 5 N·s/m", "b_r 0.005 N·m·s/rad"})
    EXPECT_TRUE(text.contains(QString::fromUtf8(words))) << words << "\n" << text.toStdString();
  EXPECT_TRUE(recommendation_text(r, GainAxis::translation).startsWith("Alone"));
}

}  // namespace
}  // namespace sonde::ui
