// SPDX-License-Identifier: GPL-3.0-or-later
// What a Viewport says of its colours.

#include <QFontMetricsF>

#include "tests/ui/views/viewport_fixture.hpp"
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
