// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/error.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning_report.hpp"
#include "engine/study/tuning/tuning_study.hpp"
#include "tests/engine/study/tuning/tuning_requests.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using test::never;
using test::pressed_boxes;
using test::spoon_in_cup;
using test::tuned;
using testing::HasSubstr;

std::string all_text(const std::filesystem::path& folder) {
  std::string out;
  for (const StudyFile& file : tuning_files(folder.string(), read_study(folder)))
    out += file.name + "\n" + file.text;
  return out;
}

TEST(Tuning, same_bits_at_any_thread_count_and_in_shards) {
  const TuningRequest request = pressed_boxes();
  const test::TempFolder whole, threads, shards;
  compute_parts(whole.path(), plan_tuning(request, 1, never), {}, 1, never);
  compute_parts(threads.path(), plan_tuning(request, 1, never), {}, 3, never);
  const std::string text = all_text(whole.path());
  EXPECT_EQ(all_text(threads.path()), text);
  for (const std::size_t i : {2u, 0u, 1u}) {
    EXPECT_THROW(all_text(shards.path()), InputError);
    compute_parts(shards.path(), plan_tuning(request, 1, never), {i, 3}, 1, never);
  }
  EXPECT_EQ(all_text(shards.path()), text);
}

void expect_coupling(Coupling::Mode mode) {
  TuningRequest request = pressed_boxes();
  request.coupling.mode = mode;
  request.device.mass.assumed = false;
  const test::TempFolder folder;
  compute_parts(folder.path(), plan_tuning(request, 1, never), {}, 2, never);
  for (const StudyFile& file : tuning_files(folder.path().string(), read_study(folder.path())))
    folder.write(file.name, file.text);
  const Coupling c = read_coupling(folder / "coupling.json");
  EXPECT_EQ(c.mode, mode);
  EXPECT_EQ(c.max_force, 10);
  EXPECT_EQ(c.max_torque, 0.2);
  EXPECT_GT(mode == Coupling::Mode::object ? c.k : c.k_t, 50);
  if (mode == Coupling::Mode::classic) {
    EXPECT_GT(c.k_r, 1e-3);
  }
  EXPECT_THAT(test::text_of(folder / "recommendation.json"), HasSubstr("limited_by"));
}

TEST(Tuning, what_it_recommends_a_scene_can_include) { expect_coupling(Coupling::Mode::object); }
TEST(Tuning, Full_of_the_classic_coupling_too) { expect_coupling(Coupling::Mode::classic); }

TEST(Tuning, no_contact_is_an_error_that_says_so) {
  TuningRequest request = pressed_boxes();
  request.path = {{0, {Quat::Identity(), {0, 0, 1}}}, {1, {Quat::Identity(), {0, 0, 2}}}};
  try {
    plan_tuning(request, 1, never);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("contact at no pose of the trajectory"));
  }
  EXPECT_THROW(tuning_contacts(pressed_boxes(), [] { return true; }), Cancelled);
}

TEST(Tuning, what_is_not_studied_is_said) {
  // Boxes flat on each other: no corner, and nothing that jams.
  TuningRequest request = pressed_boxes();
  const TuningContacts contacts = tuning_contacts(request, never);
  EXPECT_FALSE(contacts.situations.empty());
  for (const ContactKind kind : all_contact_kinds) {
    const auto is = [&](const SkippedContact& s) { return s.kind == kind; };
    const auto found = std::ranges::find_if(contacts.skipped, is);
    const bool studied = std::ranges::any_of(
        contacts.situations, [&](const TuningSituation& s) { return s.contact.kind == kind; });
    EXPECT_TRUE(studied || found != contacts.skipped.end()) << name_of(kind);
    if (kind == ContactKind::jammed) {
      ASSERT_NE(found, contacts.skipped.end());
      EXPECT_EQ(found->reason, "no such contact was found");
    }
  }
  const std::string about = plan_tuning(request, 1, never).about;
  EXPECT_THAT(about, HasSubstr(R"({"kind":"jammed","reason":"no such contact was found"})"));
}

// What is recommended for one kind of contact has been held in it until it rests, as for all.
TEST(Tuning, one_kind_of_contact_is_a_study_of_its_own) {
  TuningRequest request = test::spoon_in_cup();
  request.kind = "edge";
  const TuningContacts edge = tuning_contacts(request, never, {}, 2);
  ASSERT_EQ(edge.situations.size(), 1U);
  EXPECT_EQ(edge.situations[0].contact.kind, ContactKind::edge);
  request = pressed_boxes();
  request.device.mass.assumed = false;
  const std::string kind = name_of(tuning_contacts(request, never).situations.front().contact.kind);
  request.kind = kind;
  const TuningResults results = test::tuned(request);
  EXPECT_EQ(results.only_kind, kind);
  ASSERT_TRUE(results.ladder);
  const auto gains = recommend(results, GainAxis::object);
  EXPECT_TRUE(gains && gains->tried);
  for (const TuningLine& line : results.lines) EXPECT_EQ(line.kind, kind);
  EXPECT_THAT(recommendation_in_words(results),
              testing::Contains(
                  HasSubstr("came to rest in the " + kind + " contact, the only one studied")));
  request.kind = "jammed";
  EXPECT_THROW(tuning_contacts(request, never), InputError);
}

TEST(Tuning, stiffness_beyond_all_reason_gives_a_map_of_it) {
  TuningRequest request = pressed_boxes();
  request.device.mass.assumed = false;
  request.low = 1e11;
  request.high = 1e12;
  request.ratio = 2;
  const test::TempFolder folder;
  compute_parts(folder.path(), plan_tuning(request, 1, never), {}, 2, never);
  const TuningResults results = read_tuning("", read_study(folder.path()));
  for (const TuningLine& line : results.lines)
    for (const SweepPoint& run : line.columns.front().runs) {
      EXPECT_NE(fault_of(run.report, line.axis), HoldFault::none) << run.stiffness;
    }
  EXPECT_EQ(recommend(results, GainAxis::object)->stiffness, 0);
}

TEST(Tuning, Full_a_contact_that_cannot_be_held_is_left_out_with_the_reason) {
  // On the rim of the cup the spoon slips off where theory has it hardest.
  const TuningContacts contacts = tuning_contacts(spoon_in_cup(), never);
  std::size_t harder = 0;
  for (const SkippedContact& each : contacts.skipped) {
    EXPECT_NE(each.reason, "");
    harder += std::ranges::any_of(
        contacts.situations, [&](const TuningSituation& s) { return s.contact.kind == each.kind; });
  }
  EXPECT_GT(harder, 0u);
}

TEST(Tuning, Full_within_five_percent_of_a_ten_times_finer_sweep) {
  TuningRequest request = spoon_in_cup();
  const AxisGains coarse = *recommend(tuned(request), GainAxis::object);
  request.ratio = 1.002;
  const AxisGains fine = *recommend(tuned(request), GainAxis::object);
  EXPECT_NEAR(coarse.stiffness / fine.stiffness, 1, 0.05);
  EXPECT_NEAR(coarse.boundary / fine.boundary, 1, 0.05);
  RecordProperty("stiffness",
                 std::to_string(coarse.stiffness) + " " + std::to_string(fine.stiffness));
  RecordProperty("boundary", std::to_string(coarse.boundary) + " " + std::to_string(fine.boundary));
}

}  // namespace
}  // namespace sonde
