// SPDX-License-Identifier: GPL-3.0-or-later
// Large bodies are drawn simplified while something moves, and in full at rest: by drags of the
// window's own. References: the torus's equation, and the picture that was drawn in full.

#include "ui/views/detail.hpp"

#include <gtest/gtest.h>
#include <vtkPolyData.h>

#include <QLabel>

#include "engine/mesh_io/read_mesh.hpp"
#include "tests/ui/torus_text.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/views/glyphs.hpp"
#include "ui/views/simplified.hpp"
#include "ui/views/surface.hpp"

namespace sonde::ui::test {
namespace {

/// Two tori of 45 000 triangles, one through the other, the servo paused.
class DetailTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    folder.write("torus.off", torus(150));
    folder.write("tori.sonde.json", R"({"fixed": {"mesh": "torus.off"},
        "probe": {"mesh": "torus.off", "pose": [0.03, 0, 0.005, 0.8, 0.6, 0, 0]}})");
    open({path("tori.sonde.json")});
    ASSERT_TRUE(wait_until([this] { return shown().separation.status == Status::penetrating; }));
    window->viewport().set_shown(Layer::hint, false);
    window->set_paused(true);
    rest();
  }
  void rest() {
    ASSERT_TRUE(wait_until([this] { return view().simplified_made(); }));
    wait(300);
    ASSERT_TRUE(wait_until([this] { return !view().simplified() && !view().dirty(); }));
  }
  Viewport& view() { return window->viewport(); }
  QString rates() { return window->findChild<QLabel*>("rates")->text(); }
  /// The camera goes to and fro, and stops where it was.
  void shake() {
    send(QEvent::MouseButtonPress, {600, 300}, Qt::RightButton, Qt::RightButton, {});
    for (const double x : {603.0, 600.0}) {
      const std::size_t frames = window->frames();
      send(QEvent::MouseMove, {x, 300}, Qt::NoButton, Qt::RightButton, {});
      ASSERT_TRUE(wait_until([&] { return window->frames() > frames; }));
    }
    send(QEvent::MouseButtonRelease, {600, 300}, Qt::RightButton, Qt::NoButton, {});
  }
  /// Of the pictures at rest and in movement, of what is on show: the share of pixels between.
  double share_between() {
    view().invalidate();
    rest();
    const QImage full = view().picture();
    shake();
    EXPECT_TRUE(view().simplified());
    const QImage simple = view().picture();
    rest();
    EXPECT_LT(pixels_between(full, view().picture()), 20) << "at rest all detail is back";
    return pixels_between(full, simple) / double(full.width() * full.height());
  }
};

TEST_F(DetailTest, what_moves_is_simplified_and_the_status_says_so) {
  EXPECT_TRUE(wait_until([&] { return !rates().contains("simplified"); })) << "at rest";
  double x = 600;
  send(QEvent::MouseButtonPress, {x, 300}, Qt::RightButton, Qt::RightButton, {});
  EXPECT_TRUE(wait_until([&] {
    send(QEvent::MouseMove, {x += 1, 300}, Qt::NoButton, Qt::RightButton, {});
    wait(20);
    return view().simplified() && rates().contains("simplified while moving");
  }));
  send(QEvent::MouseButtonRelease, {x, 300}, Qt::RightButton, Qt::NoButton, {});
  EXPECT_TRUE(wait_until([&] { return !view().simplified(); }));
  EXPECT_TRUE(wait_until([&] { return !rates().contains("simplified"); }));
}

TEST_F(DetailTest, the_probe_s_movement_counts_too) {
  window->set_paused(false);
  EXPECT_TRUE(wait_until([&] {
    drag(Qt::LeftButton, {600, 300}, {4, 0});
    wait(20);
    return view().simplified();
  }));
  window->set_paused(true);
  rest();
}

TEST_F(DetailTest, a_body_looks_the_same_simplified) {
  EXPECT_LT(share_between(), 0.02);
  act("xray_fixed");
  EXPECT_LT(share_between(), 0.02) << "x-ray";
  act("xray_fixed");
  act("cut");
  EXPECT_LT(share_between(), 0.02) << "cut";
}

/// What is painted shows as it does at rest: a simplified surface does not cover it, and lets no
/// more of it through.
TEST_F(DetailTest, gap_colours_are_not_covered) {
  const Contact& contact = shown().separation.clusters[0].contact;
  view().camera().look_at(contact.on_fixed, contact.normal, any_normal(contact.normal), 0.3);
  view().set_shown(Layer::ghost, false);
  act("hide_probe");
  picture();
  rest();
  const QImage bare = view().picture();
  act("gap_colours");
  ASSERT_TRUE(wait_until([&] { return pixels_between(bare, picture()) > 1000; }));
  rest();
  const QImage full = view().picture();
  shake();
  EXPECT_TRUE(view().simplified());
  const int painted = pixels_between(bare, full);
  EXPECT_LT(pixels_between(full, view().picture()), 0.2 * painted);
}

TEST_F(DetailTest, pictures_for_files_are_in_full_also_of_what_moves) {
  const PictureOptions options{.size = {640, 480}};
  const Instant now{.snapshot = shown(), .searched = {}, .live = false};
  const QImage at_rest = view().picture(now, options);
  rest();
  ASSERT_TRUE(window->save_picture(path("rest.png")));
  shake();
  EXPECT_TRUE(view().simplified());
  EXPECT_EQ(pixels_between(at_rest, view().picture(now, options)), 0);
  shake();
  EXPECT_TRUE(view().simplified());
  ASSERT_TRUE(window->save_picture(path("moving.png")));
  const QRect canvas(view().mapTo(window.get(), QPoint()), view().size());
  EXPECT_LT(pixels_between(QImage(path("rest.png")).copy(canvas),
                           QImage(path("moving.png")).copy(canvas)),
            20);
}

TEST_F(WindowTest, small_bodies_are_never_simplified) {
  open_cubes();
  drag(Qt::RightButton, {600, 300}, {40, 0});
  picture();
  EXPECT_FALSE(window->viewport().simplified());
}

/// The distance of a point from the torus's surface, by its equation.
TEST(SimplifiedTest, it_has_few_triangles_near_the_surface) {
  const sonde::test::TempFolder folder;
  folder.write("torus.off", torus(150));
  const Soup soup = triangulate_all(read_mesh(folder / "torus.off"));
  const auto full = make_surface(soup);
  full->ComputeBounds();
  const auto simple = simplified(*full);
  EXPECT_LE(simple->GetNumberOfPolys(), simplified_triangles);
  EXPECT_GE(simple->GetNumberOfPolys(), simplified_triangles / 5);
  for (vtkIdType i = 0; i < simple->GetNumberOfPoints(); ++i) {
    const Vec3 x(simple->GetPoint(i));
    const double off = std::hypot(std::hypot(x.x(), x.y()) - 0.1, x.z()) - 0.035;
    EXPECT_LT(std::abs(off), 0.001) << "of a torus 270 mm across";
  }
}

}  // namespace
}  // namespace sonde::ui::test
