// SPDX-License-Identifier: GPL-3.0-or-later
// What a Viewport says of its colours.

#include <QFontMetricsF>

#include "tests/ui/views/viewport_fixture.hpp"
#include "ui/base/theme.hpp"
#include "ui/views/hint_view.hpp"

namespace sonde::ui::test {
namespace {

class ViewportLegendTest : public ViewportAloneTest {
 protected:
  HintView& hints() const {
    return *static_cast<HintView*>(view->findChild<QWidget*>("hint_view"));
  }
  /// The legend is the first of the plates.
  double height() const { return hints().boxes().at(0).height(); }
  double line() const { return QFontMetricsF(hints().font()).height() + 2; }
};

TEST_F(ViewportLegendTest, each_layer_on_show_has_its_lines) {
  struct Lines {
    Layer layer;
    int count;
  };
  for (const auto& [layer, count] :
       {Lines{Layer::ghost, 1}, Lines{Layer::nearest, 1}, Lines{Layer::straight, 1},
        Lines{Layer::bound, 1}, Lines{Layer::stiffness, 1}, Lines{Layer::clearance, 1},
        Lines{Layer::contacts, 1}, Lines{Layer::wrench, 2}, Lines{Layer::measures, 1},
        Lines{Layer::defects, 2}, Lines{Layer::grid, 1}, Lines{Layer::crossings, 1},
        Lines{Layer::screw, 0}, Lines{Layer::mended, 0}}) {
    view->set_shown(layer, false);
    const double without = height();
    view->set_shown(layer, true);
    EXPECT_NEAR(height() - without, count * line(), 1e-6) << int(layer);
  }
}

/// Reference: what is drawn where the ghost lies over the probe, but for how bright it is lit.
TEST_F(ViewportLegendTest, the_ghost_is_named_in_the_colour_that_it_has_over_the_probe_too) {
  Separation& held = now.snapshot.separation;
  held.status = Status::penetrating;
  held.device.p = {0, 0, 0.06};
  held.separated.p = {0, 0, 0.072};
  view->set_shown(Layer::hint, false);
  view->set_shown(Layer::ghost, true);
  look_from({0.01, 0.02, 1});
  const QImage picture = view->picture();
  const QColor seen = picture.pixelColor(
      (view->on_screen({0.01, 0.01, 0.092}) * picture.devicePixelRatio()).toPoint());
  const QColor& named = colour::ghost_on_probe;
  EXPECT_NEAR(seen.hslHueF(), named.hslHueF(), 0.02) << seen.name().toStdString();
  EXPECT_NEAR(seen.greenF() / seen.blueF(), named.greenF() / named.blueF(), 0.1);
}

TEST_F(ViewportLegendTest, a_cut_has_its_line_and_gaps_have_a_scale_of_their_own) {
  const double before = height();
  Seeing seeing;
  seeing.cut.on = true;
  view->set_seeing(seeing);
  EXPECT_NEAR(height() - before, line(), 1e-6);
  view->set_seeing({});
  EXPECT_NEAR(height(), before, 1e-6);
  const std::size_t plates = hints().boxes().size();
  view->set_shown(Layer::gaps, true);
  EXPECT_EQ(hints().boxes().size(), plates) << "no gap was measured yet";
  Gaps gaps;
  gaps.reach = 0.002;
  view->set_gaps(gaps);
  EXPECT_EQ(hints().boxes().size(), plates + 1);
  view->set_shown(Layer::gaps, false);
  EXPECT_EQ(hints().boxes().size(), plates);
}

}  // namespace
}  // namespace sonde::ui::test
