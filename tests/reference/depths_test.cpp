// SPDX-License-Identifier: GPL-3.0-or-later
// depths.csv and the files of deep pairs against what they are said to hold. Depths are checked by
// the definition of σ (the mean squared displacement, integrated over the triangles) and by the
// exact test of freedom; that no smaller ones are known, by a short search with another seed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/reference/brute_search.hpp"
#include "tests/reference/cases.hpp"
#include "tests/reference/depths_file.hpp"
#include "tests/reference/measure.hpp"
#include "tests/reference/one_projection.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/columns.hpp"

namespace sonde::reference {
namespace {

std::vector<Row> rows_in(const std::string& file) {
  return read_rows(std::string(SONDE_REFERENCE) + "/" + file);
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = rows_in("depths.csv");
  return all;
}

/// Those of all three files.
std::vector<Row> known_rows() {
  std::vector<Row> out = rows();
  for (const char* const file : {"deep_tuning.csv", "deep_reporting.csv"})
    std::ranges::copy(rows_in(file), std::back_inserter(out));
  return out;
}

std::vector<Row> rows_of(const std::string& pair) {
  static const std::vector<Row> all = known_rows();
  std::vector<Row> out;
  for (const Row& row : all)
    if (row.pair == pair) out.push_back(row);
  return out;
}

TEST(Depths, every_case_has_its_row) {
  std::size_t count = 0;
  for (const PairSpec* spec : known_specs()) {
    const std::vector<Row> of_pair = rows_of(spec->name);
    EXPECT_EQ(static_cast<int>(of_pair.size()), case_count(*spec)) << spec->name;
    EXPECT_NO_THROW(family_of(spec->name)) << "a claim is held against whole families";
    for (std::size_t i = 0; i < of_pair.size(); ++i)
      EXPECT_EQ(of_pair[i].index, static_cast<int>(i)) << name(of_pair[i]);
    count += of_pair.size();
  }
  EXPECT_EQ(known_rows().size(), count) << "rows of a pair that is not there";
  EXPECT_GE(rows().size(), 200U);
  EXPECT_GE(pair_specs().size(), 12U);
  EXPECT_EQ(deep_tuning_specs().size() + deep_reporting_specs().size(), 16U);
}

void check(const Row& row, const Case& at, const Body& probe, const Body& fixed,
           const test::Moments& moments) {
  SCOPED_TRACE(name(row));
  EXPECT_EQ(row.kind, name(at.kind));
  EXPECT_EQ(row.triangles_a, probe.soup.triangles.size());
  EXPECT_EQ(row.triangles_b, fixed.soup.triangles.size());
  EXPECT_LT((row.pose.p - at.pose.p).norm(), 1e-9 * fixed.mass.radius);
  EXPECT_LT(row.pose.q.angularDistance(at.pose.q), 1e-7);
  EXPECT_TRUE(overlap(probe, fixed, Transform(row.pose), Doubt::exact));
  EXPECT_FALSE(overlap(probe, fixed, Transform(row.separated), Doubt::exact));
  const double sigma = test::mean_squared_displacement(moments, row.pose, row.separated);
  // What overlaps counts once: columns say how much, to their own error.
  const double known_to = probe.repairs.overlaps ? 1e-3 : 1e-6;
  EXPECT_NEAR(std::sqrt(sigma), row.best, known_to * row.best);
  EXPECT_LE(row.best, *std::min_element(row.seeds.begin(), row.seeds.end()));
  EXPECT_GE(row.pdt, row.best);
}

TEST(Depths, poses_overlap_and_their_answers_are_free_and_as_far_away_as_said) {
  for (const PairSpec* spec : known_specs()) {
    const auto probe = spec->probe(), fixed = spec->fixed();
    const std::vector<Case> all = cases(*spec, *probe, *fixed);
    const test::Moments moments =
        probe->repairs.overlaps ? test::moments_by_columns(*probe, 400) : test::moments(*probe);
    for (const Row& row : rows_of(spec->name))
      check(row, all.at(static_cast<std::size_t>(row.index)), *probe, *fixed, moments);
  }
}

/// The bodies of every pair, by its name.
std::map<std::string, const PairSpec*> specs() {
  std::map<std::string, const PairSpec*> out;
  for (const PairSpec* spec : known_specs()) out[spec->name] = spec;
  return out;
}

/// Some rows of pairs on which a descent is cheap.
std::vector<Row> sample(std::size_t count) {
  std::vector<Row> out;
  for (const char* pair :
       {"egg-egg", "ring-ring", "trefoil-trefoil", "rod-trefoil", "hook-hook", "soup-soup",
        "soup-ring", "part-nefertiti", "eight-eight", "nefertiti-mask", "anchor-rotor"})
    for (const Row& row : rows_of(pair)) out.push_back(row);
  std::mt19937_64 random(20);
  std::shuffle(out.begin(), out.end(), random);
  out.resize(std::min(out.size(), count));
  return out;
}

TEST(Depths, a_short_search_finds_nothing_better_and_mostly_the_same) {
  const auto specs = reference::specs();
  BruteOptions options;
  options.directions = 24, options.starts = 40, options.hops = 20, options.polished = 6;
  options.seed = 1234;
  int searched = 0, within_1 = 0;
  for (const Row& row : sample(20)) {
    const PairSpec& spec = *specs.at(row.pair);
    const auto probe = spec.probe(), fixed = spec.fixed();
    const double depth = brute_search(*probe, *fixed, row.pose, options).depth;
    EXPECT_GT(depth, row.best * (1 - repeats_to)) << name(row) << ": sonde-reference again?";
    ++searched, within_1 += depth <= 1.01 * row.best;
  }
  EXPECT_EQ(searched, 20);
  EXPECT_GE(within_1, 15);
}

/// What the static search makes of every n-th row.
void check_search(const std::vector<Row>& of, Method method, std::size_t every,
                  double share_within_5) {
  const auto specs = reference::specs();
  StaticOptions options;
  options.method = method;
  std::size_t searched = 0, within_5 = 0;
  for (std::size_t i = 0; i < of.size(); i += every) {
    const Row& row = of[i];
    const PairSpec& spec = *specs.at(row.pair);
    const Measured m = measure(row, {spec.probe(), spec.fixed()}, options);
    EXPECT_TRUE(m.free) << name(row);
    EXPECT_LE(m.lower_bound.value_or(0), m.reference) << name(row);
    EXPECT_GT(m.got.depth, row.best * (1 - repeats_to)) << name(row) << ": mend the reference";
    ++searched, within_5 += m.excess() <= 0.05;
  }
  std::printf("  %zu of %zu within 5 %%\n", within_5, searched);
  EXPECT_GE(static_cast<double>(within_5), share_within_5 * static_cast<double>(searched));
}

/// Of every n-th row, at least that share has the same PD_t, to a thousandth, with seed 1 as with
/// the bodies exchanged, at the inverse pose and with that seed.
void check_exchanged(const std::vector<Row>& of, std::size_t every, std::uint64_t seed,
                     double share) {
  const auto specs = reference::specs();
  std::size_t searched = 0, same = 0;
  StaticOptions there{.method = Method::pdt, .seed = 1, .want_lower_bound = false}, back = there;
  back.seed = seed;
  for (std::size_t i = 0; i < of.size(); i += every) {
    const Row& row = of[i];
    const PairSpec& spec = *specs.at(row.pair);
    const auto probe = spec.probe(), fixed = spec.fixed();
    const double one = separate_static({probe, fixed}, row.pose, there).depth;
    const double other = separate_static({fixed, probe}, inverse(row.pose), back).depth;
    ++searched, same += std::abs(one - other) <= 1e-3 * std::min(one, other);
    if (std::abs(one - other) > 1e-3 * std::min(one, other))
      std::printf("  %s: %g and %g\n", name(row).c_str(), one, other);
  }
  std::printf("  %zu of %zu the same\n", same, searched);
  EXPECT_GE(static_cast<double>(same), share * static_cast<double>(searched));
}

// Reference: the same two bodies, exchanged: a way out of one is a way out of the other.
TEST(Depths, pdt_of_exchanged_bodies_is_the_same) {
  check_exchanged(sample(30), 1, 1, 0.99);
  check_exchanged(rows_in("deep_reporting.csv"), 8, 1, 0.99);
}
// Measured: all 244 with the same seed. With another one 239, of which four of the others are
// soups, which have no sketches, and 95 of the 96: as many as two seeds for the same problem.
TEST(Depths, Full_pdt_of_exchanged_bodies_is_the_same) {
  check_exchanged(rows(), 1, 1, 0.99);
  check_exchanged(rows(), 1, 2, 0.97);
  check_exchanged(rows_in("deep_reporting.csv"), 1, 2, 0.98);
}

// Reference: PD_t of the committed depths, which no free pose that is only shifted beats.
TEST(Depths, one_projection_ends_free_and_no_nearer_than_the_reference) {
  const auto specs = reference::specs();
  int near = 0;
  for (const Row& row : sample(30)) {
    const PairSpec& spec = *specs.at(row.pair);
    const Measured m = measure_one_projection(row, {spec.probe(), spec.fixed()});
    EXPECT_EQ(m.got.status, Status::penetrating) << name(row);
    EXPECT_TRUE(m.free) << name(row);
    EXPECT_GT(m.excess(), -repeats_to) << name(row);
    near += m.excess() <= 0.05;
  }
  EXPECT_GE(near, 8);
}

/// The lower bound of every n-th row, which has to be below any free pose. As a search does, it
/// tells the bound what depth is known.
void check_bounds(std::size_t every, double median, BoundOptions options) {
  const auto specs = reference::specs();
  std::vector<double> ratios;
  std::string loaded;
  std::shared_ptr<const Body> probe, fixed;
  for (std::size_t i = 0; i < rows().size(); i += every) {
    const Row& row = rows()[i];
    if (loaded != row.pair)
      probe = specs.at(row.pair)->probe(), fixed = specs.at(row.pair)->fixed(), loaded = row.pair;
    options.known = row.best;
    const auto bound = depth_lower_bound(*probe, *fixed, row.pose, {}, options);
    const bool solid = probe->solid || fixed->solid;
    EXPECT_TRUE(bound || !solid) << name(row);
    EXPECT_LE(bound.value_or(0), row.best) << name(row);
    if (!bound || !solid) continue;
    EXPECT_GT(*bound, 0) << name(row);
    ratios.push_back(*bound / row.best);
  }
  std::sort(ratios.begin(), ratios.end());
  std::printf("  median %.3f, worst %.3f\n", ratios[ratios.size() / 2], ratios.front());
  EXPECT_GE(ratios[ratios.size() / 2], median);
}

// Reference: the committed depths, each that of a free pose. Measured on all of them: a median of
// 0.85 by the default work, 0.76 by a quarter of it.
TEST(Depths, the_lower_bound_is_below_a_sample) { check_bounds(5, 0.75, {}); }
TEST(Depths, Full_the_lower_bound_is_below_all) {
  check_bounds(1, 0.82, {});
  check_bounds(1, 0.73, {.work = 5000});
}

/// Time is over before the bodies are looked at, on any machine. Where rings are linked, the
/// nearest way out that starts outside is 5 to 12 times as deep as the reference.
TEST(Depths, without_any_time_the_answer_is_where_sketches_say) {
  const PairSpec& spec = *specs().at("ring-ring");
  auto fixed = spec.fixed();
  const Pair pair(spec.probe(), std::move(fixed));
  int linked = 0;
  for (const Row& row : rows_of("ring-ring")) {
    if (row.kind != "linked") continue;
    const Measured got = measure(
        row, pair, {.method = Method::pdt, .budget = {.microseconds = 1}, .whole_bound = true});
    EXPECT_TRUE(got.free) << name(row);
    EXPECT_LT(got.excess(), 0.5) << name(row);
    ++linked;
  }
  EXPECT_GE(linked, 4);
}

TEST(Depths, the_static_search_finds_nine_tenths_of_a_sample) {
  check_search(rows(), Method::pdg, 9, 0.9);
}
TEST(Depths, the_translational_search_finds_nine_tenths_of_a_sample) {
  check_search(rows(), Method::pdt, 9, 0.9);
}
// Measured on all of them, three seeds: 375 of 384 within 5 % on the families that were in sight
// when the search was tuned, 188 of 192 on the others; where no overlaps are pushed apart 329 and
// 179.
TEST(Depths, the_static_search_finds_nine_tenths_of_deep_concave_poses) {
  check_search(rows_in("deep_tuning.csv"), Method::pdg, 6, 0.9);
  check_search(rows_in("deep_reporting.csv"), Method::pdg, 3, 0.9);
}

}  // namespace
}  // namespace sonde::reference
