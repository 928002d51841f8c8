// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/stiffness_view.hpp"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QStringList>

#include "engine/body/body.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui {
namespace {

/// The labels of a box of 60 × 40 × 20 mm that is pressed flat on a wall, or lies elsewhere.
class StiffnessLabels {
 public:
  QStringList at(const Pose& X_FM, Coupling::Mode mode = Coupling::Mode::object) const {
    Snapshot snapshot;
    snapshot.separation = separate_static(pair_, X_FM, {});
    snapshot.coupling.k = 480;
    snapshot.coupling.mode = mode;
    vtkNew<vtkRenderer> renderer;
    GlyphShapes shapes;
    StiffnessView view(*renderer, shapes);
    const MassProperties& mass = pair_.probe().mass;
    Frame frame{snapshot, mass, LengthUnit(mass.radius), 1e-4};
    frame.pair = &pair_;
    view.show(frame);
    QStringList out;
    for (const Label& label : view.labels()) out << label.text;
    return out;
  }

 private:
  Pair pair_{sonde::test::body(sonde::test::box({0.06, 0.04, 0.02})),
             sonde::test::body(sonde::test::box({1, 1, 0.2}))};
};

// Reference: pressing is resisted with k, turns out of the plane with kÎ, and nothing else is.
TEST(StiffnessView, writes_what_a_flat_contact_resists) {
  const StiffnessLabels labels;
  EXPECT_EQ(labels.at({Quat::Identity(), {0.013, 0.021, 0.11 - 1e-3}}),
            QStringList({"480 N/m", "0.160 N·m/rad", "0.0800 N·m/rad"}));
}

TEST(StiffnessView, says_why_there_is_none_and_nothing_where_the_probe_is_free) {
  const StiffnessLabels labels;
  EXPECT_TRUE(labels.at({Quat::Identity(), {0, 0, 0.2}}).isEmpty());
  EXPECT_EQ(labels.at({Quat::Identity(), {0, 0, 0.109}}, Coupling::Mode::classic),
            QStringList{"felt stiffness: of the object norm only"});
}

}  // namespace
}  // namespace sonde::ui
