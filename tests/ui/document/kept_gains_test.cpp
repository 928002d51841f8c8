// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/kept_gains.hpp"

#include <gtest/gtest.h>

#include <clocale>

#include "engine/base/error.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::ui::test {
namespace {

KeptGains some() {
  KeptGains kept;
  kept.of_scene.k = 500;
  kept.sets[0].k = 800.1234567890123;
  kept.sets[1].mode = Coupling::Mode::classic;
  kept.sets[1].k_t = 1000.0 / 3;
  kept.active = 1;
  return kept;
}

TEST(KeptGains, are_read_to_the_bit) {
  const sonde::test::TempFolder folder;
  const auto file = folder / "deep/gains.json";
  const KeptGains kept = some();
  EXPECT_FALSE(read_kept_gains(file, kept.of_scene)) << "there is none yet";
  write_kept_gains(file, kept);
  const auto read = read_kept_gains(file, kept.of_scene);
  ASSERT_TRUE(read);
  EXPECT_TRUE(same(read->sets[0], kept.sets[0]));
  EXPECT_TRUE(same(read->sets[1], kept.sets[1]));
  EXPECT_EQ(read->active, 1u);
}

TEST(KeptGains, give_way_to_a_scene_that_somebody_has_changed) {
  const sonde::test::TempFolder folder;
  const auto file = folder / "gains.json";
  const KeptGains kept = some();
  write_kept_gains(file, kept);
  Coupling changed = kept.of_scene;
  changed.k = 300;
  EXPECT_FALSE(read_kept_gains(file, changed));
  EXPECT_TRUE(read_kept_gains(file, kept.sets[1])) << "the scene was saved with what was active";
  EXPECT_FALSE(read_kept_gains(file, kept.sets[0]));
}

TEST(KeptGains, a_scene_and_a_device_have_a_file_of_their_own) {
  Scene scene;
  scene.file = "/a/x.sonde.json";
  Scene other = scene;
  other.file = "/b/x.sonde.json";
  Scene meshes;
  meshes.probe.mesh = "/a/p.off";
  meshes.fixed.mesh = "/a/f.off";
  const auto of = kept_gains_file(scene, "sigma.7");
  EXPECT_EQ(of, kept_gains_file(scene, "sigma.7"));
  EXPECT_NE(of, kept_gains_file(scene, "omega.7"));
  EXPECT_NE(of, kept_gains_file(other, "sigma.7"));
  EXPECT_NE(of, kept_gains_file(meshes, "sigma.7"));
}

TEST(KeptGains, a_broken_file_is_named_with_the_reason) {
  const sonde::test::TempFolder folder;
  const auto why = [&](const std::string& text) -> std::string {
    const auto file = folder.write("gains.json", text);
    try {
      read_kept_gains(file, {});
    } catch (const InputError& bad) {
      return bad.what();
    }
    return "";
  };
  EXPECT_NE(why("{").find("gains.json"), std::string::npos);
  EXPECT_NE(why(R"({"version": 1, "sets": []})").find("mode"), std::string::npos);
  EXPECT_NE(why(R"({"version": 1, "sets": [{"mode": "object", "k": -3}]})").find("k must be"),
            std::string::npos);
}

}  // namespace
}  // namespace sonde::ui::test
