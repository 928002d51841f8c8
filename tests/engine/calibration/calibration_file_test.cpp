// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/calibration/calibration_file.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

Calibration made_up_pairs() {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {{{"a on b",
            Answers::search,
            Method::pdg,
            true,
            {{500, {0, 0.1, infinite}, {{0.2, 0.3}}}, {0, {}}},
            "fits"},
           {"a on b", Answers::tick, Method::pdt, false, {{50, {1e-3}}}}}};
}

std::string said_of(const std::string& text) {
  try {
    calibration_in(text, "c.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CalibrationFile, reads_back_what_was_written) {
  const Calibration got = calibration_in(to_json(made_up_pairs()), "c.json"),
                    want = made_up_pairs();
  ASSERT_EQ(got.series.size(), want.series.size());
  for (std::size_t i = 0; i < want.series.size(); ++i) {
    EXPECT_EQ(got.series[i].pair, want.series[i].pair);
    EXPECT_EQ(got.series[i].family, want.series[i].family);
    EXPECT_EQ(got.series[i].answers, want.series[i].answers);
    EXPECT_EQ(got.series[i].method, want.series[i].method);
    EXPECT_EQ(got.series[i].has_sketches, want.series[i].has_sketches);
    ASSERT_EQ(got.series[i].points.size(), want.series[i].points.size());
    for (std::size_t k = 0; k < want.series[i].points.size(); ++k) {
      EXPECT_EQ(got.series[i].points[k].time_us, want.series[i].points[k].time_us);
      EXPECT_EQ(got.series[i].points[k].errors, want.series[i].points[k].errors);
      EXPECT_EQ(got.series[i].points[k].far_out, want.series[i].points[k].far_out);
    }
  }
}

TEST(CalibrationFile, one_that_is_cut_off_is_refused_wherever) {
  const std::string whole = to_json(made_up_pairs());
  for (std::size_t size = 0; size + 2 < whole.size(); ++size)
    EXPECT_TRUE(said_of(whole.substr(0, size)).starts_with("c.json:")) << size;
}

TEST(CalibrationFile, other_versions_and_values_are_refused_with_the_line) {
  EXPECT_EQ(said_of("{\"calibration\": 2,\n\"new\": 1}"),
            "c.json:1: a calibration of version 2; this program reads version 1: measure it anew "
            "(sonde calibrate)");
  const auto with = [](const std::string& points) {
    return said_of(
        "{\"calibration\": 1, \"series\": [\n{\"pair\": \"p\", \"answers\": \"search\", "
        "\"method\": \"pdg\", \"sketched\": true, \"points\": [" +
        points + "]}]}");
  };
  EXPECT_EQ(with("{\"time_us\": 1, \"errors\": [0, 1, null]}"), "accepted");
  EXPECT_EQ(with("{\"time_us\": -1, \"errors\": []}"),
            "c.json:2: \"time_us\" is -1; it must be 0 or more");
  EXPECT_EQ(with("{\"time_us\": 1, \"errors\": [1, 0.5]}"),
            "c.json:2: an error of 0.5 after 1; they must not be negative, and ascend");
  EXPECT_EQ(with("{\"time_us\": 1, \"errors\": [-1]}"),
            "c.json:2: an error of -1 after 0; they must not be negative, and ascend");
  EXPECT_TRUE(with("{\"time_us\": 1}").starts_with("c.json:2: ")) << "no errors";
  EXPECT_TRUE(with("{\"time_us\": 1, \"errors\": [], \"more\": 1}").starts_with("c.json:2: "));
  EXPECT_EQ(said_of("{\"calibration\": 1, \"series\": []}"),
            "c.json:1: a calibration of nothing: \"series\" is empty");
  EXPECT_TRUE(said_of("[]").starts_with("c.json:1: "));
  EXPECT_TRUE(said_of("{}").starts_with("c.json:1: "));
}

}  // namespace
}  // namespace sonde
