// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "engine/simd/instruction_set.hpp"

namespace sonde::test {

/// The instruction sets that this machine has.
inline std::vector<InstructionSet> supported_sets() {
  std::vector<InstructionSet> out;
  for (int i = 0; i < static_cast<int>(InstructionSet::count); ++i)
    if (is_supported(static_cast<InstructionSet>(i))) out.push_back(static_cast<InstructionSet>(i));
  return out;
}

}  // namespace sonde::test
