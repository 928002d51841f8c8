// SPDX-License-Identifier: GPL-3.0-or-later
// The sets of vector instructions that kernels are compiled for, and which of them this program
// runs. Every kernel is chosen by instruction_set(), so a program runs one set. Each set gives the
// same bits.
#pragma once

#include <string_view>

// For __attribute__((target(...))) and the pragmas of lanes.hpp.
#define SONDE_TARGET_AVX2 "avx2"
#define SONDE_TARGET_AVX512 "avx512f,avx512vl,avx512dq,avx512bw"

namespace sonde {

/// From narrow to wide vectors. The baseline is the set that the whole build is compiled for.
enum class InstructionSet { baseline, avx2, avx512, count };

std::string_view name_of(InstructionSet set) noexcept;

bool is_supported(InstructionSet set) noexcept;

/// The set with the widest vectors that this processor runs; or that which the environment variable
/// SONDE_INSTRUCTION_SET names, for reports of faults. A name that stands for no set here has no
/// effect: check_instruction_set() says so.
InstructionSet chosen_instruction_set() noexcept;

/// The same, as it was when this was first called: a program runs one set. Inline, since kernels
/// of some 50 ns are chosen by it.
inline InstructionSet instruction_set() noexcept {
  static const InstructionSet set = chosen_instruction_set();
  return set;
}

/// Throws InputError where SONDE_INSTRUCTION_SET names no set, or one that this processor lacks.
void check_instruction_set();

}  // namespace sonde
