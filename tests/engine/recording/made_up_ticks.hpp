// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/recording/recording_writer.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {

constexpr double made_up_radius = 0.05;  ///< m, of the probe

/// Ticks at 1 kHz of a probe that goes to and fro through contacts, every field different from its
/// default in one tick or another. Not what any servo would find.
inline std::vector<Snapshot> made_up_ticks(std::size_t count, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  const auto vector = [&] { return Vec3(number(), number(), number()); };
  std::vector<Snapshot> ticks(count);
  for (std::size_t i = 0; i < count; ++i) {
    Snapshot& tick = ticks[i];
    const double phase = 0.01 * static_cast<double>(i);
    tick.tick = i + 1;
    tick.time = 1e-3 * static_cast<double>(i);
    Separation& s = tick.separation;
    s.device = {Quat(Eigen::AngleAxisd(phase, Vec3(1, 2, 3).normalized())),
                Vec3(std::sin(phase), 0.1, 1e-3 * number())};
    s.status = i % 5 == 0 ? Status::separated : Status::penetrating;
    if (i % 97 == 3) s.status = Status::failed, s.reason = i % 2 == 0 ? "one" : "another";
    s.separated = s.device;
    if (s.status == Status::penetrating) {
      s.separated.p += 1e-3 * vector();
      s.separated.q = s.device.q * Quat(Eigen::AngleAxisd(1e-2 * number(), vector().normalized()));
      s.depth = 1e-3 * (1 + number());
      s.sigma = s.depth * s.depth;
      for (std::size_t c = 0; c < i % 7; ++c)
        s.contacts.push({.on_probe = made_up_radius * vector(),
                         .on_fixed = made_up_radius * vector(),
                         .normal = vector().normalized(),
                         .gap = 1e-6 * number(),
                         .multiplier = 1e-3 * (1.5 + number())});
      s.clusters = contact_clusters(s.contacts, made_up_radius);
      for (ContactCluster& cluster : s.clusters) cluster.id = 1 + random() % 100;
    }
    s.translation = s.rotation = 0.5 * s.depth;
    s.residual = 1e-9 * number() * number();
    s.iterations = static_cast<int>(i % 11);
    s.converged = i % 13 != 0;
    s.jumped = i % 29 == 0;
    tick.wrench = {vector(), 0.1 * vector(), i % 17 == 0};
    tick.hand.asked = tick.wrench;
    tick.hand.withheld = static_cast<Withheld>(i % 12);
    tick.hand.share = 0.5 * (1 + number());
    tick.hand.slewed = i % 3 == 0;
    tick.hand.held = i % 19 != 0;
    tick.hand.energy = {number(), number(), number(), number()};
    tick.hand.rows = {.age_ticks = i % 4,
                      .age = 1e-3 * static_cast<double>(i % 4),
                      .in_step = i % 4 < 2,
                      .held_back = i % 23 == 0,
                      .reach = 1e-3 * (1 + number()),
                      .refresh_us = 100 * (1.5 + number()),
                      .phases = {},  // of a running loop alone
                      .separated = s.separated};
    tick.tick_us = 10 * (1.5 + number());
    tick.rate_hz = 1000 + number();
    tick.late = i / 50;
    tick.coupling = {.mode = i % 2 == 0 ? Coupling::Mode::object : Coupling::Mode::classic,
                     .k = 500 + static_cast<double>(i / 100),
                     .b_t = 1};
  }
  return ticks;
}

/// A search that found nothing, known again by its time.
inline BackgroundResult made_up_search(double time_us) {
  BackgroundResult search;
  search.time_us = time_us;
  return search;
}

/// A scene of two small meshes in a folder, with what it takes to write recordings of it there.
class RecordingTest : public testing::Test {
 protected:
  RecordingTest() {
    const std::string tetrahedron = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    folder.write("probe.off", tetrahedron + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    folder.write("fixed.off", tetrahedron + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n\n");
    scene = read_scene(folder.write("two.sonde.json", R"({"unit": "mm",
        "probe": {"mesh": "probe.off"}, "fixed": {"mesh": "fixed.off", "scale": 2}})"));
  }
  std::filesystem::path recording(const char* name, const std::vector<Snapshot>& ticks) const {
    TickLog log(made_up_radius, 1000);
    for (const Snapshot& tick : ticks) log.add(tick);
    log.seal();
    write_recording(folder / name, header_of(scene, made_up_radius), log);
    return folder / name;
  }
  const TempFolder folder;
  Scene scene;
};

}  // namespace sonde::test
