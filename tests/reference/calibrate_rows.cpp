// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/calibrate_rows.hpp"

#include "engine/study/trade/calibrate.hpp"
#include "tests/reference/cases.hpp"

namespace sonde::reference {

Calibration calibrate_rows(const Pair& pair, const std::string& name, std::span<const Row> rows) {
  const Progress on = [](double) { return true; };
  std::vector<Pose> poses;
  std::vector<double> pdg, pdt;
  for (const Row& row : rows) {
    if (row.pair != name) continue;
    poses.push_back(row.pose);
    pdg.push_back(row.best);
    pdt.push_back(row.pdt);
  }
  Calibration out{{calibrate_searches(pair, name, Method::pdg, poses, pdg, 1, on),
                   calibrate_searches(pair, name, Method::pdt, poses, pdt, 1, on)}};
  for (CalibrationSeries& series : out.series) series.family = family_of(name);
  return out;
}

}  // namespace sonde::reference
