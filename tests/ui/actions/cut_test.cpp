// SPDX-License-Identifier: GPL-3.0-or-later
// The cut plane: by the dock, the mouse and the contact.

#include <gtest/gtest.h>

#include <QAction>
#include <QPushButton>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "engine/queries/body_queries.hpp"
#include "tests/ui/actions/seeing_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/seeing_control.hpp"
#include "ui/base/theme.hpp"
#include "ui/document/session.hpp"
#include "ui/views/body_look.hpp"
#include "ui/views/cut_view.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(SeeingTest, a_cut_takes_half_of_the_fixed_body_away_and_flips) {
  hide_overlays();
  act("from_front");
  act("hide_probe");
  const QImage whole = picture();
  auto* across = window->findChild<QPushButton*>("cut_x");
  across->click();
  EXPECT_TRUE(find<QAction>("cut")->isChecked());
  EXPECT_NEAR((cut().normal - Vec3::UnitX()).norm(), 0, 1e-12);
  window->viewport().set_shown(Layer::cut, false);
  // Its right half is the background's now, and its left half is as it was.
  const auto differs = [&](const QImage& image, double x) {
    const QPoint at = window->viewport().on_screen(Vec3(x, 0.0, 0.05)).toPoint();
    return whole.pixel(at) != image.pixel(at);
  };
  const QImage cut_right = picture();
  EXPECT_TRUE(differs(cut_right, 0.075));
  EXPECT_FALSE(differs(cut_right, 0.025));
  key(Qt::Key_C, Qt::ShiftModifier);
  const QImage cut_left = picture();
  EXPECT_FALSE(differs(cut_left, 0.075));
  EXPECT_TRUE(differs(cut_left, 0.025));
}

TEST_F(SeeingTest, the_cut_is_dragged_by_its_arrow_and_the_probe_stays) {
  const Pose before = window->session()->device_pose();
  act("from_front");
  window->findChild<QPushButton*>("cut_x")->click();
  picture();
  const auto handles = window->viewport().cut_handles();
  ASSERT_TRUE(handles);
  const QPointF from = window->viewport().on_screen(handles->centre);
  const QPointF tip =
      window->viewport().on_screen(handles->centre + handles->axes.col(2) * handles->length);
  const QPointF grip = from + 0.9 * (tip - from);
  drag(Qt::LeftButton, grip, 0.5 * (tip - from));
  EXPECT_NEAR((cut().point - handles->centre).dot(Vec3::UnitX()), 0.5 * handles->length,
              0.05 * handles->length);
  EXPECT_EQ(window->session()->device_pose().p, before.p);
  // The slider goes with it, and moves it.
  auto* place = window->findChild<QSlider*>("cut_place");
  EXPECT_GT(place->value(), 0);
  place->setValue(0);
  EXPECT_NEAR((cut().point - handles->centre).norm(), 0, 1e-9);
}

TEST_F(SeeingTest, the_cut_snaps_to_the_contact_and_holds_its_normal) {
  key(Qt::Key_C, Qt::AltModifier);
  ASSERT_TRUE(cut().on);
  const ContactClusters& clusters = shown().separation.clusters;
  ASSERT_GT(clusters.size, 0);
  double nearest = 1;
  for (const ContactCluster& c : clusters)
    nearest = std::min(nearest, (c.contact.on_fixed - cut().point).norm() +
                                    std::abs(c.contact.normal.dot(cut().normal)));
  EXPECT_NEAR(nearest, 0, 1e-9);
}

/// What a point of the plane is of.
enum class At { nothing, fixed, probe };

class CutPicture : public SeeingTest {
 protected:
  /// By the winding number of either body; the probe's section lies over the fixed body's.
  At at(const Vec3& x) const {
    const Session& session = *window->session();
    if (inside(session.probe(), inverse(shown().separation.device) * x)) return At::probe;
    return inside(session.fixed(), x) ? At::fixed : At::nothing;
  }
  /// Looked at along the plane's normal, around the contact: each pixel that is not beside an
  /// outline has the colour of what is there in the plane.
  void expect_section() {
    hide_overlays();
    for (const Layer layer : {Layer::cut, Layer::handles, Layer::clearance})
      window->viewport().set_shown(layer, false);
    const Mat3 axes = axes_of_plane(cut().normal);
    window->seeing().look_from(cut().normal, axes.col(1));
    const QImage seen = picture();
    const double reach = 0.6 * window->session()->probe().mass.radius;
    constexpr int samples = 60;
    const double step = 2 * reach / samples;
    int of_fixed = 0, of_probe = 0, wrong = 0;
    for (int i = 0; i < samples; ++i)
      for (int j = 0; j < samples; ++j) {
        const auto place = [&](double du, double dv) {
          return Vec3(cut().point + (i * step - reach + du) * axes.col(0) +
                      (j * step - reach + dv) * axes.col(1));
        };
        const At here = at(place(0, 0));
        // Four pixels to each side are of the same.
        const double around = 4 * window->viewport().metres_per_pixel(cut().point);
        const bool clear = here == at(place(around, 0)) && here == at(place(-around, 0)) &&
                           here == at(place(0, around)) && here == at(place(0, -around));
        if (here == At::nothing || !clear) continue;
        // In what the probe covers lies an outline of the fixed body.
        const QPoint pixel = window->viewport().on_screen(place(0, 0)).toPoint();
        if (!seen.rect().contains(pixel)) continue;
        const QColor expected = cut_colour(here == At::probe ? colour::probe : colour::fixed);
        const QColor found = seen.pixelColor(pixel);
        const int off = std::abs(found.red() - expected.red()) +
                        std::abs(found.green() - expected.green()) +
                        std::abs(found.blue() - expected.blue());
        (here == At::probe ? of_probe : of_fixed) += 1;
        wrong += off > 12;
      }
    EXPECT_GT(of_fixed, 100);
    EXPECT_GT(of_probe, 100);
    // The outline of the fixed body under the probe, a sample or so wide.
    EXPECT_LT(wrong, 0.04 * (of_fixed + of_probe));
    if (const char* folder = std::getenv("SONDE_TEST_PICTURES"))
      seen.save(QStringLiteral("%1/cut-%2.png").arg(folder).arg(of_fixed));
  }
};

// Reference: the winding number of either body at each point of the plane.
TEST_F(CutPicture, through_a_contact_shows_both_bodies_filled) {
  key(Qt::Key_C, Qt::AltModifier);
  ASSERT_TRUE(cut().on && cut().probe && cut().fixed);
  expect_section();
}

// The same where the bodies are hollow there, and behind the plane: no wedge shows of what is not
// in it.
TEST_F(CutPicture, of_a_peg_in_its_hole_is_of_the_plane_alone) {
  consent = Consent::once;
  open({QStringLiteral(SONDE_RESOURCES "/scenes/peg-in-hole.sonde.json")});
  window->documents().place({Quat(0.982793434, 0.052125964, -0.034759542, 0.173757659),
                             Vec3(0.003007692, -0.002006154, -0.003964612)},
                            QStringLiteral("there"));
  ASSERT_TRUE(wait_until([this] { return shown().separation.status == Status::penetrating; }));
  settle();
  window->seeing().snap_cut();
  ASSERT_TRUE(cut().on);
  expect_section();
}

}  // namespace
}  // namespace sonde::ui::test
