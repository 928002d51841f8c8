// SPDX-License-Identifier: GPL-3.0-or-later
// Every example scene opens, and its device path shows what the manual says: free, touching, deep,
// and free again, at the speed of a hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/queries/intersect.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"

namespace sonde::test {
namespace {

struct Expected {
  const char* name;
  bool fixed_solid;
  std::size_t triangles;  ///< at least as many, in the fixed body
  double depth;           ///< √PD_g, m: somewhere the path is at least as deep
};

void PrintTo(const Expected& e, std::ostream* out) { *out << e.name; }

class Scenes : public testing::TestWithParam<Expected> {
 protected:
  Scenes()
      : scene_(read_scene(std::filesystem::path(SONDE_RESOURCES) / "scenes" /
                          (std::string(GetParam().name) + ".sonde.json"))),
        probe_(load(scene_.probe, scene_.unit)),
        fixed_(load(scene_.fixed, scene_.unit)),
        path_(read_trajectory(scene_.trajectory.value())) {}

  bool overlaps(std::size_t row) const {
    return overlap(*probe_, *fixed_, Transform(path_[row].pose), Doubt::exact);
  }

  Scene scene_;
  std::shared_ptr<const Body> probe_;
  std::shared_ptr<const Body> fixed_;
  std::vector<TimedPose> path_;
};

TEST_P(Scenes, bodies_are_what_they_say) {
  EXPECT_TRUE(probe_->solid) << probe_->why;
  EXPECT_EQ(fixed_->solid, GetParam().fixed_solid) << fixed_->why;
  EXPECT_FALSE(probe_->turned);
  EXPECT_FALSE(fixed_->turned);
  EXPECT_EQ(probe_->degenerate + fixed_->degenerate, 0U);
  EXPECT_GE(fixed_->soup.triangles.size(), GetParam().triangles);
}

TEST_P(Scenes, probe_stands_where_its_path_begins) {
  const Pose X = relative_pose(scene_);
  EXPECT_LT((X.p - path_.front().pose.p).norm(), 1e-12);
  EXPECT_LT(X.q.angularDistance(path_.front().pose.q), 1e-7);
}

TEST_P(Scenes, path_goes_from_free_through_contact_to_free) {
  EXPECT_FALSE(overlaps(0));
  EXPECT_FALSE(overlaps(path_.size() - 1));
  std::size_t inside = 0;
  for (std::size_t row = 0; row < path_.size(); row += 20)
    if (overlaps(row)) ++inside;
  EXPECT_GE(static_cast<double>(inside), 0.25 * static_cast<double>(path_.size()) / 20);
}

TEST_P(Scenes, path_is_deep_somewhere) {
  StaticOptions quick;
  quick.starts = 0;
  quick.want_lower_bound = false;
  double deepest = 0;
  const Pair pair(probe_, fixed_);
  for (std::size_t row = 0; row < path_.size(); row += path_.size() / 10) {
    const Separation s = separate_static(pair, path_[row].pose, quick);
    EXPECT_NE(s.status, Status::failed) << "at " << path_[row].t << " s: " << s.reason;
    deepest = std::max(deepest, s.depth);
  }
  RecordProperty("deepest_mm", std::to_string(1e3 * deepest));
  EXPECT_GE(deepest, GetParam().depth);
}

TEST_P(Scenes, path_moves_like_a_hand) {
  for (std::size_t row = 1; row < path_.size(); ++row) {
    const double dt = path_[row].t - path_[row - 1].t;
    ASSERT_NEAR(dt, 1e-3, 1e-9);
    ASSERT_LE((path_[row].pose.p - path_[row - 1].pose.p).norm() / dt, 0.3);
    ASSERT_LE(path_[row].pose.q.angularDistance(path_[row - 1].pose.q) / dt, 6.0);
  }
}

INSTANTIATE_TEST_SUITE_P(, Scenes,
                         testing::Values(Expected{"spoon-in-cup", true, 10'000, 0.003},
                                         Expected{"torus-knots", true, 20'000, 0.004},
                                         Expected{"linked-tori", true, 20'000, 0.006},
                                         Expected{"peg-in-hole", true, 8'000, 0.001},
                                         Expected{"nut-on-bolt", true, 10'000, 0.0008},
                                         Expected{"crumpled-soup", false, 15'000, 0.003},
                                         Expected{"terrain", true, 25'000, 0.004}),
                         [](const auto& scene) {
                           std::string name = scene.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace sonde::test
