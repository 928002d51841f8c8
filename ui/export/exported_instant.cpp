// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/exported_instant.hpp"

#include <algorithm>

#include "ui/views/probe_view.hpp"

namespace sonde::ui {

ExportedInstant exported_instant_of(const Instant& instant) {
  const Snapshot& snapshot = instant.snapshot;
  ExportedInstant out{snapshot.time, snapshot.separation.device, snapshot.separation,
                      snapshot.wrench};
  if (const BackgroundResult* searched = searched_here(instant)) out.searched = *searched;
  out.clearance = signed_clearance(snapshot.separation, clearance_here(instant));
  return out;
}

std::vector<ExportedInstant> separation_in_steps(const Snapshot& snapshot,
                                                 const MassProperties& probe, int steps) {
  std::vector<ExportedInstant> instants;
  const Separation& s = snapshot.separation;
  const int count = std::max(steps, 1);
  for (int i = 0; i <= count; ++i) {
    const double part = double(i) / count;
    instants.push_back({part, on_the_way(probe, s.device, s.separated, part), s, snapshot.wrench});
  }
  return instants;
}

}  // namespace sonde::ui
