// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/crossing_finder.hpp"

#include <gtest/gtest.h>

#include "tests/ui/actions/session_fixture.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui::test {
namespace {

/// Two cubes of 100 mm in one mesh, one through the other.
std::shared_ptr<const Body> crossed_cubes() {
  PolygonSoup soup = sonde::test::box({0.1, 0.1, 0.1});
  const PolygonSoup second = soup;
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (const Vec3& point : second.points) soup.points.push_back(point + Vec3(0.05, 0.05, 0.05));
  for (auto polygon : second.polygons) {
    for (auto& corner : polygon) corner += first;
    soup.polygons.push_back(polygon);
  }
  return sonde::test::body(soup, Model::surface);
}

class CrossingFinderTest : public SessionInView {
 protected:
  void SetUp() override {
    SessionInView::SetUp();
    if (HasFatalFailure()) return;
    finder = std::make_unique<CrossingFinder>(*view, *view);
    QObject::connect(finder.get(), &CrossingFinder::say,
                     [this](const QString& what) { said << what; });
    QObject::connect(finder.get(), &CrossingFinder::given_up, [this] { ++given_up; });
    LoadedScene crossed{.pair = Pair(cube(0.04), crossed_cubes())};
    crossed.start.p = Vec3(0, 0, 0.3);
    session = make_session(crossed);
    for (const Layer layer : {Layer::hint, Layer::grid, Layer::ghost, Layer::handles})
      view->set_shown(layer, false);
    look_from({0.4, -0.4, 0.3});
  }
  void TearDown() override { finder.reset(); }
  bool says_something() {
    return wait_until([this] { return !said.isEmpty(); });
  }
  std::unique_ptr<CrossingFinder> finder;
  QStringList said;
  int given_up = 0;
};

TEST_F(CrossingFinderTest, says_and_shows_which_triangles_go_through_others) {
  const QImage without = drawn();
  finder->attach(session.get());
  EXPECT_TRUE(said.isEmpty()) << "it is not asked for yet";
  finder->set_on(true);
  ASSERT_TRUE(says_something());
  EXPECT_TRUE(said[0].startsWith("Self-intersections – probe: none, fixed body: "))
      << said[0].toStdString();
  EXPECT_TRUE(said[0].endsWith(" triangles"));
  const QImage with = drawn();
  EXPECT_GT(pixels_of_hue(with, colour::crossing), pixels_of_hue(without, colour::crossing) + 1000);
  finder->set_on(false);
  EXPECT_LT(pixels_between(without, drawn()), 20);
  EXPECT_EQ(given_up, 0);
}

TEST_F(CrossingFinderTest, looks_once_for_a_pair_of_bodies) {
  finder->attach(session.get());
  finder->set_on(true);
  ASSERT_TRUE(says_something());
  const QImage with = drawn();
  finder->set_on(false);
  finder->set_on(true);
  EXPECT_EQ(pixels_between(with, drawn()), 0) << "they are known, and there at once";
  wait(150);
  EXPECT_EQ(said.size(), 1);
}

TEST_F(CrossingFinderTest, left_on_it_looks_at_the_next_bodies_too) {
  finder->set_on(true);
  finder->attach(session.get());
  ASSERT_TRUE(says_something());
  said.clear();
  auto sound = make_session(loaded());
  finder->attach(sound.get());
  ASSERT_TRUE(says_something());
  EXPECT_EQ(said[0], "Self-intersections – probe: none, fixed body: none");
  finder->attach(nullptr);
  wait(150);
  EXPECT_EQ(said.size(), 1);
}

TEST_F(CrossingFinderTest, what_was_known_of_other_bodies_is_forgotten) {
  finder->attach(session.get());
  finder->set_on(true);
  ASSERT_TRUE(says_something());
  finder->set_on(false);
  said.clear();
  auto sound = make_session(loaded());
  finder->attach(sound.get());
  finder->set_on(true);
  ASSERT_TRUE(says_something());
  EXPECT_TRUE(said[0].endsWith("fixed body: none"));
}

/// Its pair is looked at in a worker, which must not outlast it.
TEST_F(CrossingFinderTest, what_is_closed_meanwhile_says_nothing) {
  finder->set_on(true);
  finder->attach(session.get());
  finder->attach(nullptr);
  session.reset();
  wait(150);
  EXPECT_TRUE(said.isEmpty()) << said.join('\n').toStdString();
  EXPECT_EQ(given_up, 0);
}

}  // namespace
}  // namespace sonde::ui::test
