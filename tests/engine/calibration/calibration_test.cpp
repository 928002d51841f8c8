// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/calibration/calibration.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>

#include "engine/base/numbers.hpp"
#include "engine/calibration/calibration_file.hpp"

namespace sonde {
namespace {

/// Ten errors of which nine are no more than this.
std::vector<double> nine_within(double error) {
  std::vector<double> out(9, error);
  out.push_back(10 * error);
  out.insert(out.begin(), 0);
  return out;
}

Calibration made_up_series() {
  CalibrationSeries series{"made up", Answers::search, Method::pdg, true, {}};
  series.points = {{1000, nine_within(0.16)}, {4000, nine_within(0.01)}, {0, nine_within(1e-4)}};
  return {{series}};
}

TEST(AccuracyCurve, is_the_ninth_of_ten_errors_and_logarithmic_in_between) {
  const AccuracyCurve curve(made_up_series(), Answers::search, Method::pdg, true);
  EXPECT_DOUBLE_EQ(curve.within(1000), 0.16);
  EXPECT_DOUBLE_EQ(curve.within(4000), 0.01);
  EXPECT_NEAR(curve.within(2000), 0.04, 1e-12);  // half-way: the geometric mean
  EXPECT_DOUBLE_EQ(curve.within(0), 1e-4);
  EXPECT_DOUBLE_EQ(curve.within(1e6), 0.01) << "a longer limit than was measured is no worse";
  EXPECT_EQ(curve.within(900), infinity) << "less time than was measured";
}

TEST(AccuracyCurve, may_be_of_one_pair_alone) {
  Calibration two = made_up_series();
  two.series.push_back(two.series[0]);
  two.series[1].pair = "another";
  two.series[1].points[0].errors = nine_within(0.5);
  const auto curve = [&](const char* pair) {
    return AccuracyCurve(of_pair(two, pair), Answers::search, Method::pdg, true);
  };
  EXPECT_DOUBLE_EQ(curve("made up").within(1000), 0.16);
  EXPECT_DOUBLE_EQ(curve("another").within(1000), 0.5);
  EXPECT_FALSE(curve("a third").known());
}

TEST(AccuracyCurve, of_few_pairs_is_that_of_the_worst_and_of_many_that_of_all) {
  Calibration some = made_up_series();
  const auto add = [&](double error) {
    some.series.push_back(some.series[0]);
    some.series.back().pair += std::to_string(some.series.size());
    some.series.back().points[0].errors = nine_within(error);
  };
  add(0.5);
  for (int i = 0; i < 7; ++i) add(0.01);
  const auto within = [&] {
    return AccuracyCurve(some, Answers::search, Method::pdg, true).within(1000);
  };
  EXPECT_DOUBLE_EQ(within(), 0.5) << "nine pairs";
  for (int i = 0; i < 13; ++i) add(0.01);
  EXPECT_DOUBLE_EQ(within(), 0.1) << "what 9 in 10 of 242 errors keep to: 22 are larger than 0.01";
}

TEST(AccuracyCurve, of_many_pairs_counts_each_family_alike) {
  Calibration some{std::vector<CalibrationSeries>(10, made_up_series().series[0])};
  for (std::size_t i = 0; i < 10; ++i) {
    some.series[i].family = i < 9 ? "many" : "few";
    some.series[i].points[0].errors =
        i < 9 ? std::vector<double>(10, 0.01) : std::vector<double>{0.01, 0.01, 0.2, 0.3};
  }
  const auto within = [&](double sure) {
    return AccuracyCurve(some, Answers::search, Method::pdg, true, sure).within(1000);
  };
  EXPECT_DOUBLE_EQ(within(0.75), 0.01) << "all of the one and half of the other";
  EXPECT_DOUBLE_EQ(within(0.8), 0.2) << "of 94 answers 92 keep to less";
  EXPECT_DOUBLE_EQ(within(0.9), 0.3);
}

TEST(AccuracyCurve, says_nothing_of_ticks_without_a_limit) {
  Calibration ticks = made_up_series();
  ticks.series[0].answers = Answers::tick;
  ticks.series[0].points[2].errors = {0, 0, 0};  // each compared with itself
  const AccuracyCurve curve(ticks, Answers::tick, Method::pdg, true);
  EXPECT_DOUBLE_EQ(curve.within(4000), 0.01);
  EXPECT_EQ(curve.within(0), infinity);
  Separation answer;
  answer.status = Status::penetrating;
  answer.depth = 1;
  EXPECT_EQ(claim_of(answer, 0, curve).by, Claim::By::nothing);
}

/// Errors are against references that stand off their contacts too; the true depth does not.
TEST(AccuracyCurve, is_no_finer_than_what_an_answer_stands_off) {
  Calibration exact = made_up_series();
  for (CalibrationPoint& point : exact.series[0].points) point.errors = nine_within(1e-6);
  const AccuracyCurve searches(exact, Answers::search, Method::pdg, true);
  EXPECT_NEAR(searches.within(1000), 1e-4, 1e-18);
  EXPECT_EQ(searches.within(0), 1e-4);
  EXPECT_EQ(searches.time_for(1e-5), 0) << "as long as it takes, and still not that fine";
  exact.series[0].answers = Answers::tick;
  EXPECT_NEAR(AccuracyCurve(exact, Answers::tick, Method::pdg, true).within(1000), 1e-6, 1e-20);
}

TEST(AccuracyCurve, time_and_accuracy_are_each_other_s_inverse) {
  const AccuracyCurve curve(made_up_series(), Answers::search, Method::pdg, true);
  for (const double accuracy : {0.15, 0.1, 0.05, 0.02, 0.01})
    EXPECT_NEAR(curve.within(curve.time_for(accuracy)), accuracy, 1e-9);
  EXPECT_EQ(curve.time_for(0.5), 1000) << "no less than was measured";
  EXPECT_EQ(curve.time_for(0.001), 0) << "as long as it takes";
  EXPECT_DOUBLE_EQ(budget_us({.time = 2e-3}, curve), 2000);
  EXPECT_NEAR(budget_us({.accuracy = 0.04}, curve), 2000, 1e-6);
  EXPECT_EQ(budget_us({}, curve), 0);
}

TEST(AccuracyCurve, more_time_is_never_worse_and_failures_are_infinitely_wrong) {
  Calibration calibration = made_up_series();
  calibration.series[0].points[1].errors = nine_within(0.3);
  const AccuracyCurve worse(calibration, Answers::search, Method::pdg, true);
  EXPECT_DOUBLE_EQ(worse.within(4000), 0.16);
  calibration.series[0].points[0].errors = {0, 0, infinity, infinity};
  const AccuracyCurve failing(calibration, Answers::search, Method::pdg, true);
  EXPECT_EQ(failing.within(1000), infinity);
  EXPECT_EQ(failing.time_for(0.35), 4000);
}

TEST(AccuracyCurve, other_pairs_serve_where_none_of_the_kind_was_measured) {
  EXPECT_TRUE(AccuracyCurve(made_up_series(), Answers::search, Method::pdg, false).known());
  const AccuracyCurve none(made_up_series(), Answers::tick, Method::pdg, true);
  EXPECT_FALSE(none.known());
  EXPECT_EQ(none.within(1000), infinity);
  EXPECT_EQ(none.time_for(0.1), 0);
}

TEST(Claim, is_the_narrower_of_the_bound_and_what_is_expected) {
  const AccuracyCurve curve(made_up_series(), Answers::search, Method::pdg, true);
  Separation answer;
  EXPECT_EQ(claim_of(answer, 1000, curve).by, Claim::By::nothing) << "a failure claims nothing";
  answer.status = Status::penetrating;
  answer.depth = 1.1;
  EXPECT_EQ(claim_of(answer, 1000, curve).by, Claim::By::expected);
  EXPECT_DOUBLE_EQ(claim_of(answer, 1000, curve).within, 0.16);
  EXPECT_EQ(claim_of(answer, 1, curve).by, Claim::By::nothing);
  answer.lower_bound = 1;
  EXPECT_EQ(claim_of(answer, 1000, curve).by, Claim::By::certified);
  EXPECT_NEAR(claim_of(answer, 1000, curve).within, 0.1, 1e-12);
  EXPECT_EQ(claim_of(answer, 4000, curve).by, Claim::By::expected);
  answer.status = Status::separated;
  EXPECT_EQ(claim_of(answer, 1, curve).within, 0) << "a free probe is free";
}

TEST(Claim, of_a_long_way_out_is_as_those_are) {
  Calibration calibration = made_up_series();
  for (CalibrationPoint& point : calibration.series[0].points) point.far_out = nine_within(0.5);
  const AccuracyCurve curve(calibration, Answers::search, Method::pdg, true);
  Separation answer;
  answer.status = Status::penetrating;
  answer.depth = 1.1;
  EXPECT_DOUBLE_EQ(claim_of(answer, 1000, curve).within, 0.16);
  answer.far_out = true;
  EXPECT_DOUBLE_EQ(claim_of(answer, 1000, curve).within, 0.5);
  for (CalibrationPoint& point : calibration.series[0].points) point.far_out->clear();
  const AccuracyCurve none(calibration, Answers::search, Method::pdg, true);
  EXPECT_EQ(claim_of(answer, 1000, none).by, Claim::By::nothing) << "none was measured";
  const AccuracyCurve old(made_up_series(), Answers::search, Method::pdg, true);
  EXPECT_DOUBLE_EQ(claim_of(answer, 1000, old).within, 0.16) << "they were not told apart";
}

TEST(AccuracyCurve, is_of_as_many_answers_as_are_to_be_sure) {
  const auto within = [](double sure) {
    return AccuracyCurve(made_up_series(), Answers::search, Method::pdg, true, sure).within(1000);
  };
  EXPECT_DOUBLE_EQ(within(0.5), 0.16);
  EXPECT_DOUBLE_EQ(within(0.99), 1.6);
}

TEST(Calibration, keeps_of_another_what_was_not_measured_again) {
  Calibration other = made_up_series();
  other.series.push_back(other.series[0]);
  other.series[1].pair = "another";
  Calibration now = made_up_series();
  now.series[0].points.resize(1);
  const Calibration all = joined(now, other);
  ASSERT_EQ(all.series.size(), 2U);
  EXPECT_EQ(all.series[0].pair, "another");
  EXPECT_EQ(all.series[0].points.size(), 3U);
  EXPECT_EQ(all.series[1].points.size(), 1U);
}

// ---- what ships ----

/// What is measured of all pairs but those of one family.
Calibration without(const std::string& left_out) {
  Calibration out = default_calibration();
  std::erase_if(out.series,
                [&](const CalibrationSeries& series) { return family_of(series) == left_out; });
  return out;
}

struct Kind {
  const char* name;
  Answers answers;
  Method method;
  bool has_sketches;
};

class DefaultCalibration : public testing::TestWithParam<Kind> {
 protected:
  static bool is_of_kind(const CalibrationSeries& series) {
    return series.answers == GetParam().answers && series.method == GetParam().method &&
           series.has_sketches == GetParam().has_sketches;
  }
};

// Reference: the errors of each family, which the curve that makes the claim has not seen. At each
// time over all families, since what the curve claims there hangs on which is left out.
TEST_P(DefaultCalibration, nine_in_ten_claims_hold_on_families_that_the_fit_did_not_see) {
  std::map<double, std::array<int, 2>> held_by_time;  // held, claimed
  std::map<std::string, std::array<int, 2>> held_by_family;
  std::set<std::string> pairs;
  for (const CalibrationSeries& series : default_calibration().series) {
    if (!is_of_kind(series)) continue;
    pairs.insert(series.pair);
    const AccuracyCurve curve(without(family_of(series)), series.answers, series.method,
                              series.has_sketches);
    for (const CalibrationPoint& point : series.points) {
      const auto count = [&](const std::vector<double>& errors, bool far_out) {
        // What the reference itself repeats to, some 1e-4, is nothing to hold a claim to.
        const double within = std::max(curve.within(point.time_us, far_out), 1e-4);
        if (!std::isfinite(within)) return;
        for (auto* held : {&held_by_time[point.time_us], &held_by_family[family_of(series)]})
          for (const double error : errors) ++(*held)[1], (*held)[0] += error <= within;
      };
      count(point.errors, false);
      if (point.far_out) count(*point.far_out, true);
    }
  }
  EXPECT_GE(pairs.size(), GetParam().answers == Answers::tick ? 7U : 10U);
  EXPECT_GE(held_by_time.size(), 6U);
  int held = 0, claimed = 0;
  for (const auto& [time_us, count] : held_by_time) {
    std::printf("  %6.0f us: %d of %d claims hold\n", time_us, count[0], count[1]);
    EXPECT_GE(count[0], 0.8 * count[1]) << time_us << " us";
    held += count[0], claimed += count[1];
  }
  for (const auto& [name, count] : held_by_family)
    std::printf("  %s: %d of %d claims hold\n", name.c_str(), count[0], count[1]);
  std::printf("  all: %d of %d, %.1f in 100\n", held, claimed, 100.0 * held / claimed);
  EXPECT_GE(held, 0.85 * claimed);
  EXPECT_LE(held, 0.95 * claimed);
}

INSTANTIATE_TEST_SUITE_P(
    Each, DefaultCalibration,
    testing::Values(Kind{"pdg", Answers::search, Method::pdg, true},
                    Kind{"pdt", Answers::search, Method::pdt, true},
                    Kind{"pdg_without_sketches", Answers::search, Method::pdg, false},
                    Kind{"pdt_without_sketches", Answers::search, Method::pdt, false},
                    Kind{"pdg_ticks", Answers::tick, Method::pdg, true},
                    Kind{"pdt_ticks", Answers::tick, Method::pdt, true}),
    [](const testing::TestParamInfo<Kind>& kind) { return std::string(kind.param.name); });

}  // namespace
}  // namespace sonde
