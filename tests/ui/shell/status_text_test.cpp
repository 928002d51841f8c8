// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/status_text.hpp"

#include <gtest/gtest.h>

#include "engine/body/body.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::ui::test {
namespace {

const LengthUnit of_50_mm(0.05);

Instant in_contact() {
  Instant now;
  now.snapshot.separation.status = Status::penetrating;
  now.snapshot.separation.depth = 0.01;
  return now;
}

TEST(Happening, is_the_state_of_the_probe) {
  Instant now = in_contact();
  EXPECT_EQ(happening(now, of_50_mm),
            QStringLiteral("In contact, %1 deep.").arg(of_50_mm.text(0.01)));
  now.snapshot.separation.status = Status::separated;
  EXPECT_EQ(happening(now, of_50_mm), "Free.");
}

TEST(Happening, a_free_probe_has_its_clearance_where_it_was_measured_there) {
  Instant now;
  now.snapshot.separation.status = Status::separated;
  now.clearance = GaugedClearance{.device = {}, .distance = 0.0123};
  EXPECT_EQ(happening(now, of_50_mm), QStringLiteral("Free, %1 clear.").arg(of_50_mm.text(0.0123)));
  now.clearance->device.p.x() = 1;
  EXPECT_EQ(happening(now, of_50_mm), "Free.");
}

TEST(Happening, a_force_that_is_withheld_has_its_reason) {
  Instant now = in_contact();
  for (const Withheld why : {Withheld::stopped, Withheld::let_go, Withheld::changed,
                             Withheld::untrusted, Withheld::not_finite, Withheld::stalled,
                             Withheld::unsettled, Withheld::diverged, Withheld::shut_down}) {
    now.snapshot.hand.withheld = why;
    EXPECT_EQ(happening(now, of_50_mm),
              QStringLiteral("No force (%1).").arg(QString::fromUtf8(words(why))));
  }
  now.snapshot.hand.withheld = Withheld::failed;
  now.snapshot.separation.reason = "the bodies are too far apart";
  EXPECT_EQ(happening(now, of_50_mm),
            "No force (no separated pose was found: the bodies are too far apart).");
}

TEST(Happening, a_pause_comes_before_all_else) {
  Instant now = in_contact();
  now.snapshot.hand.withheld = Withheld::failed;
  now.snapshot.paused = true;
  EXPECT_EQ(happening(now, of_50_mm), "Paused.");
}

TEST(Happening, says_where_a_nearer_way_out_is_blocked) {
  Instant now = in_contact();
  const QString held = QStringLiteral("In contact, %1 deep.").arg(of_50_mm.text(0.01));
  now.searched = BackgroundResult{};
  now.searched->nearest = FoundSeparation{.depth = 0.002, .separated = {}};
  ASSERT_EQ(way_out(now.snapshot.separation, *now.searched), WayOut::nearer_blocked);
  EXPECT_EQ(happening(now, of_50_mm),
            held + QLatin1Char(' ') + QString::fromUtf8(words(WayOut::nearer_blocked)));
  now.searched->nearest->depth = 0.01;
  EXPECT_EQ(happening(now, of_50_mm), held);
}

TEST(Natures, say_of_both_bodies_whether_their_inside_counts_and_why) {
  const auto solid = sonde::test::body(sonde::test::box({1, 1, 1}));
  const auto surface = sonde::test::body(sonde::test::box({1, 1, 1}), Model::surface);
  ASSERT_TRUE(solid->solid);
  ASSERT_FALSE(surface->solid);
  const auto text = [](const Body& body) { return QString::fromStdString(body.why); };
  EXPECT_EQ(natures(*solid, *surface),
            QStringLiteral("Probe: solid (%1)   Fixed body: surface (%2)")
                .arg(text(*solid), text(*surface)));
}

TEST(Natures, say_what_was_done_to_a_mesh) {
  Body body;
  body.solid = true;
  body.why = "closed";
  body.repairs.caps = 1;
  body.degenerate = 3;
  body.offset = {.by = -1e-5, .furthest = 1e-5, .least = 1e-5};
  const QString text = natures(body, Body());
  EXPECT_TRUE(
      text.startsWith("Probe: solid (closed), mended, 3 triangles without area set aside, "
                      "taken 10 µm smaller (allowance)   Fixed body"))
      << text.toStdString();
}

TEST(Natures, say_of_the_probe_by_what_its_mass_is_where_that_is_not_plain) {
  Body body;
  body.solid = true;
  body.why = "1 of 2 parts is closed: its inside counts";
  body.mass_why = "by area: 97 % of the area belongs to open parts";
  EXPECT_EQ(natures(body, body),
            "Probe: solid (1 of 2 parts is closed: its inside counts), mass by area: 97 % of the "
            "area belongs to open parts   Fixed body: solid (1 of 2 parts is closed: its inside "
            "counts)");
}

}  // namespace
}  // namespace sonde::ui::test
