// SPDX-License-Identifier: GPL-3.0-or-later
// What was mended, in the window: the bar, the way to each place, and taking it back.
#include "ui/actions/repairs_control.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <algorithm>
#include <cstdlib>

#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/defects.hpp"
#include "tests/support/shapes.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/base/elided_label.hpp"
#include "ui/base/theme.hpp"
#include "ui/document/session.hpp"

namespace sonde::ui::test {
namespace {

using sonde::test::as_off;
using sonde::test::icosphere;
using sonde::test::without;

constexpr double radius = 0.05;

/// Near a pole of the sphere, by the middles of triangles.
auto near(const Vec3& pole, double by) {
  return [=](const Vec3& x) { return (x - radius * pole).norm() < by; };
}

PolygonSoup ball() { return icosphere(radius, 3); }

PolygonSoup with_turned_triangle() {
  PolygonSoup mesh = ball();
  std::swap(mesh.polygons[100][1], mesh.polygons[100][2]);
  return mesh;
}

PolygonSoup with_two_holes() {
  return without(without(ball(), near(Vec3::UnitZ(), 0.005)), near(-Vec3::UnitY(), 0.005));
}

/// With so wide a mouth that it is a surface, and so narrow a one that it could be a solid.
PolygonSoup vessel() { return without(ball(), near(Vec3::UnitZ(), 0.025)); }

class RepairsTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (HasFatalFailure()) return;
    folder.write("ball.off", as_off(ball()));
    folder.write("turned.off", as_off(with_turned_triangle()));
    folder.write("holes.off", as_off(with_two_holes()));
    folder.write("vessel.off", as_off(vessel()));
  }
  /// The probe above the fixed body, free.
  void open_pair(const char* probe, const char* fixed) {
    const auto file = folder.write(
        "pair.sonde.json", std::string(R"({"unit": "m", "probe": {"mesh": ")") + probe +
                               R"(", "pose": [0.13, 0, 0, 1, 0, 0, 0]}, "fixed": {"mesh": ")" +
                               fixed + R"("}})");
    open({QString::fromStdString(file.string())});
    ASSERT_EQ(failed, 0) << (complaints.empty() ? "" : complaints[0].toStdString());
  }
  /// The same with the bar unfolded, where there is something to say.
  void unfold_pair(const char* probe, const char* fixed) {
    open_pair(probe, fixed);
    if (button("mended_unfold")->isVisible()) button("mended_unfold")->click();
    settle();
  }
  RepairsBar& bar() { return window->repairs().bar(); }
  QString line(const char* name) { return find<ElidedLabel>(name)->text(); }
  QToolButton* button(const char* name) { return find<QToolButton>(name); }
  /// Presses it, and waits until the bodies were exchanged.
  void press_and_wait(const char* name) {
    const int before = opened;
    button(name)->click();
    ASSERT_TRUE(wait_until([&] { return opened > before; }));
  }
  void undo_and_wait() {
    const int before = opened;
    act("undo");
    ASSERT_TRUE(wait_until([&] { return opened > before; }));
  }
  const Scene& scene_now() { return window->documents().document().content().scene; }
  void wait_for_flight() {
    ASSERT_TRUE(wait_until([this] { return !window->repairs().flying(); }));
  }
  /// Pictures for the eye, where SONDE_TEST_PICTURES names a folder.
  void keep_picture(const char* name) {
    const char* to = std::getenv("SONDE_TEST_PICTURES");
    if (to) window->save_picture(QString::fromUtf8(to) + '/' + name + ".png");
  }
  /// Of the picture: pixels of the caps' hue.
  int cap_pixels() {
    const QImage image = picture();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor pixel = image.pixelColor(x, y);
        count += std::abs(pixel.hsvHue() - colour::cap.hsvHue()) < 15 &&
                 pixel.hsvSaturation() > 60 && pixel.value() > 60;
      }
    return count;
  }
};

TEST_F(RepairsTest, the_bar_comes_for_a_mended_body_alone) {
  unfold_pair("ball.off", "ball.off");
  EXPECT_FALSE(bar().isVisible());
  unfold_pair("ball.off", "turned.off");
  ASSERT_TRUE(bar().isVisible());
  EXPECT_EQ(line("mended_fixed"), "turned: 1 triangle turned");
  EXPECT_FALSE(find<ElidedLabel>("mended_probe")->isVisible());
  const QString tip = find<ElidedLabel>("mended_fixed")->toolTip();
  EXPECT_TRUE(tip.contains("agree with neighbours")) << tip.toStdString();
  EXPECT_TRUE(tip.startsWith("<p>Fixed body turned"));
  EXPECT_FALSE(button("mended_fixed_close")->isVisible());
  unfold_pair("ball.off", "ball.off");
  EXPECT_FALSE(bar().isVisible());
}

TEST_F(RepairsTest, the_bar_lies_above_the_view_and_not_in_it) {
  unfold_pair("holes.off", "turned.off");
  for (const QSize size : {QSize(1280, 800), QSize(960, 600)}) {
    window->resize(size);
    settle();
    const QRect view(window->viewport().mapTo(window.get(), QPoint()), window->viewport().size());
    const QRect above(bar().mapTo(window.get(), QPoint()), bar().size());
    keep_picture(size.width() > 1000 ? "bar-wide" : "bar-narrow");
    EXPECT_FALSE(view.intersects(above));
    EXPECT_EQ(above.width(), view.width());
    EXPECT_LT(above.height(), 70) << "of two lines";
    for (const char* name : {"mended_probe_show", "mended_probe_repair", "mended_away"})
      EXPECT_TRUE(
          above.contains(QRect(button(name)->mapTo(window.get(), QPoint()), button(name)->size())))
          << name;
  }
}

// Reference: where the triangles are missing in the file.
TEST_F(RepairsTest, show_flies_to_each_place_in_turn) {
  unfold_pair("ball.off", "holes.off");
  ASSERT_EQ(window->session()->fixed().places.all, 2u);
  EXPECT_EQ(line("mended_fixed"), "holes: 2 openings closed");
  std::vector<Vec3> seen;
  for (int press = 0; press < 3; ++press) {
    QElapsedTimer clock;
    clock.start();
    button("mended_fixed_show")->click();
    EXPECT_LT(clock.elapsed(), 100) << "the window is not kept waiting";
    EXPECT_EQ(find<QLabel>("mended_fixed_places")->text(),
              QStringLiteral("%1 of 2").arg(press % 2 + 1));
    wait_for_flight();
    picture();
    const Viewport& view = window->viewport();
    const Vec3 eye = view.camera().eye();
    for (const Vec3& pole : {Vec3(Vec3::UnitZ()), Vec3(-Vec3::UnitY())})
      if (pole.dot(eye.normalized()) > 0.9) {
        seen.push_back(pole);
        const QPointF at = view.on_screen(radius * pole);
        EXPECT_TRUE(QRectF(view.rect()).adjusted(40, 40, -40, -40).contains(at))
            << at.x() << ", " << at.y();
        EXPECT_GT(cap_pixels(), 200) << "it is seen from outside";
        keep_picture("shown-place");
      }
  }
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_NE(seen[0], seen[1]);
  EXPECT_EQ(seen[0], seen[2]) << "after the last comes the first";
}

TEST_F(RepairsTest, of_very_many_places_the_first_are_shown_and_all_are_counted) {
  constexpr int side = 33;
  const PolygonSoup one = sonde::test::triangulated(sonde::test::box({0.001, 0.001, 0.001}));
  PolygonSoup many;
  for (int i = 0; i < side * side; ++i) {
    const std::size_t at = many.points.size();
    for (const Vec3& x : one.points)
      many.points.push_back(x + 0.002 * Vec3(i % side, double(i / side), 0));
    for (Polygon polygon : one.polygons) {
      for (std::size_t& corner : polygon) corner += at;
      many.polygons.push_back(polygon);
    }
    std::swap(many.polygons.back()[0], many.polygons.back()[1]);
  }
  folder.write("many.off", as_off(many));
  unfold_pair("ball.off", "many.off");
  EXPECT_EQ(line("mended_fixed"), "many: 1089 triangles turned");
  button("mended_fixed_show")->click();
  EXPECT_EQ(find<QLabel>("mended_fixed_places")->text(), "1 of 1000");
  EXPECT_EQ(find<QLabel>("mended_fixed_places")->toolTip(), "1 of 1000 (the first of 1089)");
  window->resize(960, 600);
  settle();
  EXPECT_EQ(bar().width(), window->viewport().width());
  EXPECT_EQ(window->width(), 960) << "the bar makes nothing wider";
  keep_picture("very-many");
}

TEST_F(RepairsTest, a_key_goes_through_both_bodies) {
  unfold_pair("turned.off", "holes.off");
  activate();
  for (const char* expected : {"1 of 1", "1 of 2", "2 of 2", "1 of 1"}) {
    key(Qt::Key_N);
    wait_for_flight();
    const char* name =
        QLatin1String(expected).endsWith('1') ? "mended_probe_places" : "mended_fixed_places";
    EXPECT_EQ(find<QLabel>(name)->text(), expected);
  }
  // The probe's place is where the probe is.
  const Vec3 at = window->session()->device_pose() * window->session()->probe().places.places[0].at;
  picture();
  const QPointF on_screen = window->viewport().on_screen(at);
  EXPECT_TRUE(QRectF(window->viewport().rect()).contains(on_screen));
  EXPECT_LT((window->viewport().camera().target() - at).norm(), 1e-9);
}

TEST_F(RepairsTest, as_in_the_file_is_a_step_that_can_be_undone) {
  unfold_pair("ball.off", "holes.off");
  ASSERT_TRUE(window->session()->fixed().solid);
  press_and_wait("mended_fixed_repair");
  EXPECT_EQ(scene_now().fixed.repair, Repair::none);
  EXPECT_FALSE(window->session()->fixed().solid);
  EXPECT_TRUE(window->session()->fixed().caps.triangles.empty());
  EXPECT_TRUE(window->session()->probe().solid) << "the other stays";
  EXPECT_EQ(line("mended_fixed"), "holes: taken as in the file");
  EXPECT_EQ(button("mended_fixed_repair")->text(), "Mend it");
  keep_picture("as-in-the-file");
  EXPECT_FALSE(button("mended_fixed_show")->isVisible());
  EXPECT_TRUE(window->documents().document().modified());
  EXPECT_EQ(find<QAction>("undo")->text(), "&Undo: Take holes as in the file");
  undo_and_wait();
  EXPECT_EQ(scene_now().fixed.repair, Repair::automatic);
  EXPECT_TRUE(window->session()->fixed().solid);
  EXPECT_EQ(line("mended_fixed"), "holes: 2 openings closed");
  EXPECT_FALSE(window->documents().document().modified());
  press_and_wait("mended_fixed_repair");
  press_and_wait("mended_fixed_repair");
  EXPECT_TRUE(window->session()->fixed().solid) << "mended again";
  EXPECT_TRUE(complaints.empty());
}

TEST_F(RepairsTest, what_could_be_a_solid_is_closed_when_asked) {
  unfold_pair("vessel.off", "ball.off");
  ASSERT_FALSE(window->session()->probe().solid);
  ASSERT_TRUE(window->session()->probe().repairs.could_be_solid);
  ASSERT_TRUE(bar().isVisible());
  EXPECT_TRUE(line("mended_probe").contains("could be a solid"));
  EXPECT_FALSE(button("mended_probe_show")->isVisible()) << "nothing was done";
  EXPECT_FALSE(button("mended_probe_repair")->isVisible());
  EXPECT_EQ(cap_pixels(), 0);
  press_and_wait("mended_probe_close");
  EXPECT_EQ(scene_now().probe.model, Model::solid);
  EXPECT_TRUE(window->session()->probe().solid);
  EXPECT_EQ(line("mended_probe"), "vessel: 1 opening closed");
  EXPECT_FALSE(button("mended_probe_close")->isVisible());
  act("from_above");
  EXPECT_GT(cap_pixels(), 500);
  act("theme_light");
  keep_picture("closed-in-light");
  act("theme_dark");
  darken();
  // As in the file it is no solid: it need not be one any more.
  press_and_wait("mended_probe_repair");
  EXPECT_FALSE(window->session()->probe().solid);
  EXPECT_EQ(scene_now().probe.model, Model::automatic);
  undo_and_wait();
  undo_and_wait();
  EXPECT_EQ(scene_now().probe.model, Model::automatic);
  EXPECT_FALSE(window->session()->probe().solid);
  EXPECT_TRUE(complaints.empty());
}

TEST_F(RepairsTest, folded_away_it_stays_away_until_it_is_unfolded) {
  open_pair("ball.off", "holes.off");
  EXPECT_FALSE(bar().isVisible()) << "the view is the largest thing";
  EXPECT_EQ(line("mended_fixed_notice"), "2 openings closed");
  const int without = window->viewport().height();
  button("mended_unfold")->click();
  EXPECT_TRUE(bar().isVisible());
  EXPECT_TRUE(find<QAction>("mended_bar")->isChecked());
  settle();
  EXPECT_LT(window->viewport().height(), without);
  act("swap_bodies");
  ASSERT_TRUE(wait_until([this] { return opened == 2; }));
  EXPECT_TRUE(bar().isVisible()) << "it is the same document";
  EXPECT_EQ(line("mended_probe_notice"), "2 openings closed");
  EXPECT_FALSE(find<QWidget>("mended_fixed_notice")->isVisible());
  button("mended_away")->click();
  EXPECT_FALSE(bar().isVisible());
  EXPECT_FALSE(find<QAction>("mended_bar")->isChecked());
  act("mended_bar");
  EXPECT_TRUE(bar().isVisible());
  open_pair("ball.off", "turned.off");
  EXPECT_FALSE(bar().isVisible()) << "another document";
  EXPECT_EQ(line("mended_fixed_notice"), "1 triangle turned");
  act("new");
  EXPECT_FALSE(button("mended_unfold")->isVisible());
}

TEST_F(RepairsTest, the_keyboard_reaches_each_button_and_each_has_a_name) {
  unfold_pair("vessel.off", "holes.off");
  activate();
  button("mended_probe_close")->setFocus();
  for (const char* name : {"mended_fixed_show", "mended_fixed_repair", "mended_away"}) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_TRUE(QApplication::focusWidget());
    EXPECT_EQ(QApplication::focusWidget()->objectName(), QLatin1String(name));
    EXPECT_FALSE(QApplication::focusWidget()->accessibleName().isEmpty());
    EXPECT_FALSE(QApplication::focusWidget()->toolTip().isEmpty());
  }
  EXPECT_TRUE(button("mended_fixed_show")->toolTip().contains("(N)"));
  button("mended_fixed_show")->setFocus();
  QTest::keyClick(button("mended_fixed_show"), Qt::Key_Space);
  EXPECT_EQ(find<QLabel>("mended_fixed_places")->text(), "1 of 2");
  QTest::keyClick(button("mended_fixed_show"), Qt::Key_Return);
  EXPECT_EQ(find<QLabel>("mended_fixed_places")->text(), "2 of 2");
  EXPECT_FALSE(window->session()->paused()) << "Space pauses elsewhere";
  // From the view through the docks F6 comes to the bar, or to what unfolds it, and back.
  for (const bool folded : {false, true}) {
    window->repairs().set_away(folded);
    window->viewport().canvas()->setFocus();
    const QWidget& aim = folded ? static_cast<QWidget&>(window->repairs().notice()) : bar();
    bool reached = false;
    for (int press = 0; press < 20 && !reached; ++press) {
      QTest::keyClick(window.get(), Qt::Key_F6);
      reached = aim.isAncestorOf(QApplication::focusWidget());
    }
    EXPECT_TRUE(reached);
    QTest::keyClick(window.get(), Qt::Key_F6);
    EXPECT_TRUE(window->viewport().canvas()->hasFocus());
  }
}

TEST_F(RepairsTest, as_in_the_scene_it_is_said_from_the_start) {
  const auto file = folder.write("as.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "ball.off", "repair": "none", "pose": [0.13, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "holes.off", "repair": "none"}})");
  open({QString::fromStdString(file.string())});
  EXPECT_EQ(line("mended_fixed_notice"), "taken as in the file");
  EXPECT_EQ(line("mended_fixed"), "holes: taken as in the file");
  EXPECT_FALSE(find<ElidedLabel>("mended_probe")->isVisible()) << "nothing of it is to be mended";
  const auto surface = folder.write("surface.sonde.json", R"({"unit": "m",
      "probe": {"mesh": "ball.off", "pose": [0.13, 0, 0, 1, 0, 0, 0]},
      "fixed": {"mesh": "vessel.off", "model": "surface"}})");
  open({QString::fromStdString(surface.string())});
  EXPECT_FALSE(button("mended_unfold")->isVisible()) << "it was asked for";
}

}  // namespace
}  // namespace sonde::ui::test
