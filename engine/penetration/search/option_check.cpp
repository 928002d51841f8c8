// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/search/option_check.hpp"

#include "engine/base/error.hpp"

namespace sonde {

void check(const StaticOptions& options) {
  const auto need = [](bool holds, const char* reason) {
    if (!holds) throw InputError::in("the options", reason);
  };
  need(options.method == Method::pdg || options.method == Method::pdt, "there is no such method");
  need(options.budget.steps >= 0, "budget.steps must be 0 (none) or more");
  need(options.budget.work >= 0, "budget.work must be 0 (none) or more");
  need(options.budget.microseconds >= 0, "budget.microseconds must be 0 (none) or more");
  need(options.starts >= 1, "starts must be at least 1");
  need(options.agreement >= 1, "agreement must be at least 1");
  need(options.sure > 0 && options.sure < 1, "sure must be above 0 and below 1");
  need(options.share_for_bound >= 0 && options.share_for_bound <= 1,
       "share_for_bound must be 0 to 1");
}

}  // namespace sonde
