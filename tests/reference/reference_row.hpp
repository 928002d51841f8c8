// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/reference/brute_search.hpp"
#include "tests/reference/cases.hpp"
#include "tests/reference/depths_file.hpp"

namespace sonde::reference {

struct Reference {
  Row row;
  std::array<Origin, 3> origins{};  ///< of each seed's best
};

/// The brute-force search at one case, with three seeds; `starts` random starts each.
Reference reference_row(const PairSpec& spec, const Body& probe, const Body& fixed, const Case& at,
                        int starts);

}  // namespace sonde::reference
