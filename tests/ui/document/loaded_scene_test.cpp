// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/loaded_scene.hpp"

#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QWindow>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/ui/drop_files.hpp"
#include "tests/ui/window_fixture.hpp"
#include "ui/actions/stiffness_control.hpp"
#include "ui/base/resources.hpp"
#include "ui/devices/device_control.hpp"

namespace sonde::ui::test {
namespace {

TEST_F(WindowTest, a_bad_file_keeps_what_was_open) {
  open_cubes();
  Session* const before = window->session();
  folder.write("bad.sonde.json", "{\"unit\": \"m\", ");
  folder.write("bad.off", "OFF\n1 1 0\n0 0\n");
  window->prompts().ask_scene = [this] { return path("bad.sonde.json"); };
  act("open_scene");
  ASSERT_TRUE(wait_until([this] { return failed == 1; }));
  open({path("cube.off"), path("bad.off")}, 1.0);
  open({path("no-such.sonde.json")});
  // One mesh asks for the other; to give up is no error.
  window->prompts().ask_meshes = [](const QString&) {
    return std::optional<std::pair<QString, QString>>();
  };
  open({path("cube.off")});
  EXPECT_EQ(failed, 4);
  EXPECT_EQ(complaints.size(), 3u);
  EXPECT_TRUE(complaints[0].contains("bad.sonde.json")) << complaints[0].toStdString();
  EXPECT_EQ(window->session(), before);
  const std::uint64_t tick = shown().tick;
  EXPECT_TRUE(wait_until([&] { return shown().tick > tick + 10; })) << "it still runs";
}

TEST_F(WindowTest, giving_up_the_unit_keeps_what_was_open) {
  open_cubes();
  Session* const before = window->session();
  open({path("large.off"), path("large.off")});
  EXPECT_EQ(failed, 1);
  EXPECT_TRUE(complaints.empty()) << "to give up is no error";
  EXPECT_EQ(window->session(), before);
}

TEST_F(WindowTest, two_meshes_ask_their_unit_and_suit_the_gains) {
  answered_unit = 1e-3;
  open({path("large.off"), path("open.off")});
  ASSERT_EQ(opened, 1);
  EXPECT_EQ(guess, "mm");
  const Session& session = *window->session();
  const double radius = session.probe().mass.radius;
  EXPECT_NEAR(radius, 0.05 * std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(session.coupling().k * 0.02 * radius, session.coupling().max_force, 1e-9);
  EXPECT_TRUE(session.probe().solid);
  EXPECT_FALSE(session.fixed().solid);
  ASSERT_TRUE(wait_until([this] { return shown().separation.status == Status::separated; }));
  auto* status = window->findChild<QLabel*>("what_happens");
  EXPECT_TRUE(wait_until([&] { return status->text().contains("open edges"); }))
      << status->text().toStdString();
  // On the side of the eye, a gap of a twentieth of the radius away.
  EXPECT_GT((com() - session.fixed().mass.com).dot(window->viewport().camera().axes().towards), 0);
}

/// Reading took no time: what was to say so must not come up later, over the question.
TEST_F(WindowTest, the_question_for_the_unit_stays_on_top_and_can_be_answered) {
  window->prompts().ask_bodies = dialogs(*window).ask_bodies;
  bool alone = false;
  constexpr int long_enough_ms = 5000;  // four seconds are Qt's own patience before progress shows
  QTimer::singleShot(long_enough_ms, window.get(), [&] {
    QWidget* question = QApplication::activeModalWidget();
    alone = question && question->objectName() == "bodies_dialog";
    for (QWidget* other : QApplication::topLevelWidgets())
      if (other != question && other != window.get() && other->isVisible()) alone = false;
    if (alone) {
      auto* ok = question->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
      QTest::mouseClick(question->windowHandle(), Qt::LeftButton, Qt::NoModifier,
                        ok->mapTo(question, ok->rect().center()));
    }
    while (QWidget* stuck = QApplication::activeModalWidget()) stuck->close();
  });
  open({path("large.off"), path("large.off")});
  EXPECT_TRUE(alone);
  EXPECT_EQ(opened, 1) << "the question did not take the click";
}

class DropTest : public WindowTest {
 protected:
  void drop(const QStringList& files) { EXPECT_TRUE(drop_files(*window, files)); }
};

TEST_F(DropTest, takes_a_scene_or_two_meshes) {
  drop({QString::fromStdString(scene.string())});
  ASSERT_TRUE(wait_until([this] { return opened == 1; }));
  answered_unit = 1e-3;
  window->prompts().ask_role = [](const QString&, int) { return std::optional(Role::pair); };
  drop({path("large.off"), path("open.off")});
  ASSERT_TRUE(wait_until([this] { return opened == 2; }));
  EXPECT_EQ(window->session()->probe().name, "large");
}

TEST_F(WindowTest, opens_again_and_again) {
  for (int i = 0; i < 5; ++i) open_cubes();
  EXPECT_EQ(opened, 5);
}

TEST_F(WindowTest, closes_while_opening) {
  window->open({QStringLiteral(SONDE_RESOURCES "/scenes/torus-knots.sonde.json")});
  wait(5);
  window.reset();
}

/// Both are read at once, each as if it were read alone: of two bad files the probe's is named.
TEST(Opening, of_two_meshes_names_the_one_that_is_bad) {
  const sonde::test::TempFolder folder;
  folder.write("bad.off", "OFF\n1 1 0\n0 0\n");
  folder.write("worse.off", "OFF\n-1 1 0\n");
  folder.write("good.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto reason = [&](const char* probe, const char* fixed) -> std::string {
    try {
      read_pair(folder / probe, folder / fixed);
    } catch (const InputError& bad) {
      return bad.what();
    }
    return "none";
  };
  EXPECT_EQ(reason("good.off", "good.off"), "none");
  for (const char* fixed : {"good.off", "worse.off"})
    EXPECT_NE(reason("bad.off", fixed).find("bad.off"), std::string::npos) << fixed;
  EXPECT_NE(reason("good.off", "worse.off").find("worse.off:2"), std::string::npos);
}

TEST(Opening, of_two_meshes_can_be_cancelled) {
  const sonde::test::TempFolder folder;
  folder.write("good.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_THROW(read_pair(folder / "good.off", folder / "good.off", [](double) { return false; }),
               Cancelled);
}

// Reference: by hand. 10 N at 2 % of 50 mm are 10 kN/m.
TEST(Opening, gains_suit_the_probe_and_do_not_exceed_the_device) {
  MassProperties probe;
  probe.radius = 0.05;
  probe.inertia = Vec3(1e-3, 2e-3, 4e-3);
  EXPECT_NEAR(suited_coupling(probe).k, 1e4, 1e-9);
  DeviceProfile device;
  device.name = "Handle";
  device.max_stiffness.value = 3000;
  EXPECT_EQ(suited_coupling(probe, &device).k, 3000);
  EXPECT_EQ(suited_coupling(probe, &device).k_t, 3000);
  const Coupling soft = suited_coupling(probe, &device), stiff = suited_coupling(probe);
  EXPECT_EQ(origin_of_gains(soft, false, probe, device), "Stiffness: as much as Handle allows.");
  EXPECT_EQ(origin_of_gains(stiff, false, probe, device),
            "As opened: k = 3000 N/m. The gains set are more than Handle allows; it renders as "
            "much as it allows.");
  EXPECT_EQ(origin_of_gains(soft, true, probe, device), "As opened: as the scene's file has them.");
  EXPECT_NE(origin_of_gains(stiff, true, probe, device).find("more than Handle allows"),
            std::string::npos);
  device.max_rotational_stiffness.value = 4;
  EXPECT_EQ(suited_coupling(probe, &device).k, 3000) << "it has no motors for torque";
  device.max_torque.value = 0.2;
  EXPECT_NEAR(suited_coupling(probe, &device).k, 4 / 1.2 / 4e-3, 1e-9)
      << "1.2 kÎ, which is felt in a turn, at most 4 N·m/rad";
  device.max_stiffness.value = device.max_rotational_stiffness.value = 1e6;
  EXPECT_NEAR(suited_coupling(probe, &device).k, 1e4, 1e-9);
  EXPECT_NE(origin_of_gains(stiff, false, probe).find("2 % of the probe's radius"),
            std::string::npos);
  EXPECT_EQ(origin_of_gains(soft, false, probe), "As opened: k = 10000 N/m.");
}

TEST_F(WindowTest, gains_of_own_meshes_follow_the_device_until_they_are_changed) {
  open({path("cube.off"), path("large.off")}, 1);
  ASSERT_EQ(failed, 0);
  const double own = window->session()->coupling().k;
  DeviceProfile soft = find_device_profile("touch", device_profile_folders());
  soft.max_stiffness.value = own / 4;
  window->devices().choose(SimulatedSource{soft});
  EXPECT_NEAR(window->session()->coupling().k, own / 4, 1e-9 * own);
  EXPECT_TRUE(find<QLabel>("gains_origin")->text().contains("allows"));
  EXPECT_FALSE(window->isWindowModified()) << "nobody has changed anything";
  window->devices().choose(MouseSource{});
  EXPECT_NEAR(window->session()->coupling().k, own, 1e-9 * own);
  type("k_value", QStringLiteral("300"));
  ASSERT_NEAR(window->session()->coupling().k, 300, 1e-9);
  // Another device: that one would bring the gains that it had.
  DeviceProfile softer = find_device_profile("sigma.7", device_profile_folders());
  softer.max_stiffness.value = 100;
  window->devices().choose(SimulatedSource{softer});
  EXPECT_NEAR(window->session()->coupling().k, 300, 1e-9) << "who chose it keeps it";
}

TEST_F(WindowTest, both_sets_of_gains_and_the_gains_as_opened_follow_the_device) {
  open({path("cube.off"), path("large.off")}, 1);
  ASSERT_EQ(failed, 0);
  const double own = window->session()->coupling().k;
  DeviceProfile soft = find_device_profile("touch", device_profile_folders());
  soft.max_stiffness.value = own / 4;
  window->devices().choose(SimulatedSource{soft});
  const GainSets& sets = window->stiffness().sets();
  EXPECT_NEAR(sets.gains(0).k, own / 4, 1e-9 * own);
  EXPECT_NEAR(sets.gains(1).k, own / 4, 1e-9 * own);
  const auto words = [this] { return find<QLabel>("gains_origin")->text(); };
  act("switch_gains");
  ASSERT_EQ(sets.active(), 1u);
  EXPECT_EQ(words(), QStringLiteral("Stiffness: as much as Touch allows."));
  type("k_value", QString::number(own, 'f', 3));
  EXPECT_TRUE(words().contains("more than Touch allows")) << words().toStdString();
  find<QPushButton>("gains_as_opened")->click();
  EXPECT_NEAR(window->session()->coupling().k, own / 4, 1e-9 * own);
  type("k_value", QStringLiteral("300"));
  window->devices().choose(MouseSource{});
  EXPECT_NEAR(sets.gains(0).k, own, 1e-9 * own) << "nobody has changed that one";
  EXPECT_NEAR(sets.gains(1).k, 300, 1e-9);
  find<QPushButton>("gains_as_opened")->click();
  EXPECT_NEAR(window->session()->coupling().k, own, 1e-9 * own) << "as the mouse has them";
}

TEST(Opening, guesses_a_unit) {
  const auto guess = [](double side) {
    MeshPair pair;
    pair.probe_size = Vec3(1, 1, 1) * side / 4;
    pair.fixed_size = Vec3(1, side, 1);
    return std::string(guess_unit(pair));
  };
  EXPECT_EQ(guess(90), "mm");
  EXPECT_EQ(guess(9), "cm");
  EXPECT_EQ(guess(1.2), "m");
}

}  // namespace
}  // namespace sonde::ui::test
