// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/penetration/contact/contact_clusters.hpp"
#include "ui/export/exported_instant.hpp"

namespace sonde::ui::test {

/// A probe in two contacts, every number another. Not what any servo would find.
inline ExportedInstant made_up_instant() {
  ExportedInstant out;
  out.time = 1.25;
  Separation& s = out.separation;
  s.status = Status::penetrating;
  s.device = {Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized())), Vec3(0.01, 0.02, 0.03)};
  s.separated = {Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, 3).normalized())), Vec3(0.01, 0.02, 0.05)};
  s.depth = 0.021;
  s.sigma = s.depth * s.depth;
  s.translation = 0.02;
  s.rotation = 0.005;
  const auto add = [&s](std::uint64_t id, double multiplier, const Vec3& at, int rows) {
    ContactCluster& cluster = s.clusters.items[static_cast<std::size_t>(s.clusters.size++)];
    cluster = {.contact = {.on_probe = at + Vec3(0, 0, 1e-4),
                           .on_fixed = at,
                           .normal = Vec3(0.6, 0, 0.8),
                           .gap = 8e-5,
                           .multiplier = multiplier},
               .rows = rows,
               .id = id};
  };
  add(7, 0.003, Vec3(0.1, 0.2, 0.3), 4);
  add(11, 0.001, Vec3(-0.1, 0.25, 0.35), 2);
  out.probe = s.device;
  out.wrench = {Vec3(1, -2, 3.5), Vec3(0.01, 0.02, -0.03)};
  return out;
}

/// The same probe, free.
inline ExportedInstant made_up_free_instant() {
  ExportedInstant out;
  out.time = 1.5;
  out.separation.status = Status::separated;
  out.separation.device.p = out.separation.separated.p = out.probe.p = Vec3(0, 0, 0.5);
  return out;
}

}  // namespace sonde::ui::test
