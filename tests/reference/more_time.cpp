// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/more_time.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace sonde::reference {

bench::Table more_time(std::span<const MoreTime> budgets) {
  bench::Table out{{{"budget", "us"},
                    {"poses", ""},
                    {"within 1 %", ""},
                    {"within 5 %", ""},
                    {"over 5 % worse than with less", ""},
                    {"over 50 % worse", ""}},
                   {}};
  std::vector<double> best;
  for (const MoreTime& each : budgets) {
    best.resize(each.all.size(), std::numeric_limits<double>::infinity());
    std::int64_t within_1 = 0, within_5 = 0, worse = 0, much_worse = 0;
    for (std::size_t i = 0; i < each.all.size(); ++i) {
      const double excess = each.all[i].excess();
      within_1 += excess <= 0.01;
      within_5 += excess <= 0.05;
      worse += 1 + excess > 1.05 * (1 + best[i]);
      much_worse += 1 + excess > 1.5 * (1 + best[i]);
      best[i] = std::min(best[i], excess);
    }
    out.rows.push_back({each.budget_us, static_cast<std::int64_t>(each.all.size()), within_1,
                        within_5, worse, much_worse});
  }
  return out;
}

}  // namespace sonde::reference
