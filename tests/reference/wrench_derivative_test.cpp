// SPDX-License-Identifier: GPL-3.0-or-later
// The derivative of the wrench against central differences, on the poses of the reference depths
// and on other real meshes. The reference is a descent solved to 1e-9 (differenced_wrench.hpp),
// where halving its step changes it by less than a thousandth.
#include "engine/penetration/sensitivity/wrench_derivative.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "engine/penetration/descent/result.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "tests/reference/cases.hpp"
#include "tests/reference/depths_file.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/differenced_wrench.hpp"
#include "tests/support/real_meshes.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::reference {
namespace {

using Sides = WrenchDerivative::Sides;

/// How far derivatives are from differences.
struct Tally {
  std::vector<double> off;  ///< relative, of all that were compared, flagged ones too
  int flagged = 0;          ///< two sides, or none
  int none = 0;
  /// There is no difference to compare with: it does not settle, or is that of another place.
  int unknown = 0;

  void add(const std::string& what, const Pair& pair, const Separation& s, Neighbours neighbours) {
    const WrenchDerivative got = wrench_derivative(pair, s, neighbours);
    const auto wanted =
        test::differenced_wrench(pair.probe(), pair.fixed(), s.device, s.separated, 1e-3);
    flagged += got.sides != Sides::all;
    none += got.sides == Sides::none;
    // A barrier lower than what a search leaves does not hold the fine solver.
    if (!wanted || wanted->from_given > 3e-3) {
      ++unknown;
      return;
    }
    const double here =
        got.sides == Sides::none
            ? 1
            : test::relative_difference(pair.probe().mass, got.d_wrench, wanted->central);
    off.push_back(here);
    // What is off is flagged. (Those at the contacts alone cannot know of others.)
    if (neighbours == Neighbours::all) {
      EXPECT_TRUE(here <= 0.01 || got.sides != Sides::all) << what << ": " << here;
    }
    if (got.sides != Sides::none) {
      EXPECT_LT((Vec6(got.d_depth) - wanted->depth).norm(), 2e-3 * wanted->depth.norm()) << what;
    }
  }

  void expect_accurate(const char* title) {
    ASSERT_FALSE(off.empty());
    std::ranges::sort(off);
    const auto within = std::ranges::count_if(off, [](double x) { return x <= 0.01; });
    const double median = off[off.size() / 2];
    std::cout << title << ": " << off.size() << " compared, median " << median << ", within 1 % "
              << within << ", flagged " << flagged << " (none " << none << "), no difference "
              << unknown << '\n';
    EXPECT_LE(median, 1e-4);
    EXPECT_GE(static_cast<double>(within), 0.95 * static_cast<double>(off.size()));
    EXPECT_LE(unknown, static_cast<int>(off.size()) / 20);
  }
};

/// What a descent makes of the best pose known, as a search leaves it.
Separation separation(const Pair& pair, const Row& row) {
  const Chart chart(pair.probe().mass, row.pose);
  Descent descent(pair.probe(), pair.fixed(), Method::pdg);
  return make_separation(chart,
                         descent.run(chart, chart.coordinates(row.separated), {}, 0, Deadline{}));
}

void check(const char* file, const std::vector<PairSpec>& specs, std::size_t every) {
  const std::vector<Row> rows = read_rows(std::string(SONDE_REFERENCE) + "/" + file);
  Tally near, all;
  std::size_t count = 0;
  for (const PairSpec& spec : specs) {
    std::vector<Row> chosen;
    for (const Row& row : rows)
      if (row.pair == spec.name && count++ % every == 0) chosen.push_back(row);
    if (chosen.empty()) continue;
    const Pair pair(spec.probe(), spec.fixed());
    for (const Row& row : chosen) {
      const Separation s = separation(pair, row);
      if (!s.converged) continue;
      near.add(name(row), pair, s, Neighbours::of_contacts);
      all.add(name(row), pair, s, Neighbours::all);
    }
  }
  near.expect_accurate("at the contacts");
  all.expect_accurate("with all neighbours");
}

TEST(WrenchDerivatives, are_those_of_differences_on_a_sample) {
  check("depths.csv", pair_specs(), 7);
  check("deep_tuning.csv", deep_tuning_specs(), 16);
}
TEST(WrenchDerivatives, Full_are_those_of_differences_on_the_reference_poses) {
  check("depths.csv", pair_specs(), 1);
}
TEST(WrenchDerivatives, Full_are_those_of_differences_on_deep_pairs) {
  check("deep_tuning.csv", deep_tuning_specs(), 1);
  check("deep_reporting.csv", deep_reporting_specs(), 1);
}

/// Poses of real meshes as they come, and what the search makes of them.
void check_real(int poses_of_each) {
  Tally near, all;
  const std::vector<std::string> files{"elk.off",     "camel.off", "elephant.off", "fandisk.off",
                                       "bunny00.off", "dino.off",  "knot1.off",    "pig.off"};
  std::mt19937_64 random(5);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto a = test::real_body(files[i]), b = test::real_body(files[(i + 3) % files.size()]);
    PolygonSoup scaled{a->soup.vertices, {}};
    for (Vec3& x : scaled.points) x *= b->mass.radius / a->mass.radius;
    for (const Triangle& t : a->soup.triangles) scaled.polygons.push_back({t[0], t[1], t[2]});
    const Pair pair(test::body(scaled), b);
    for (int found = 0, tries = 0; found < poses_of_each && tries < 50; ++tries) {
      const Pose O = test::random_pose(random, pair.probe(), pair.fixed(), 0.7);
      if (!overlap(pair.probe(), pair.fixed(), Transform(O), Doubt::exact)) continue;
      StaticOptions options;
      options.budget.steps = 3000;
      options.want_lower_bound = false;
      const Separation s = separate_static(pair, O, options);
      if (s.status != Status::penetrating || !s.converged) continue;
      ++found;
      const std::string what = files[i] + " " + std::to_string(tries);
      near.add(what, pair, s, Neighbours::of_contacts);
      all.add(what, pair, s, Neighbours::all);
    }
  }
  near.expect_accurate("real meshes, at the contacts");
  all.expect_accurate("real meshes, with all neighbours");
}

TEST(WrenchDerivatives, Full_are_those_of_differences_on_other_real_meshes) { check_real(12); }

}  // namespace
}  // namespace sonde::reference
