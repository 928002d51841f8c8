// SPDX-License-Identifier: GPL-3.0-or-later
// The sets of vector instructions that kernels are compiled for, and which of them this processor
// runs. Every kernel is chosen by widest_instruction_set(), so a program runs one set. Each set
// gives the same bits.
#pragma once

// For __attribute__((target(...))) and the pragmas of lanes.hpp.
#define SONDE_TARGET_AVX2 "avx2"
#define SONDE_TARGET_AVX512 "avx512f,avx512vl,avx512dq,avx512bw"

namespace sonde {

/// From narrow to wide vectors. The baseline is the set that the whole build is compiled for.
enum class InstructionSet { baseline, avx2, avx512, count };

inline bool is_supported(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
  if (set == InstructionSet::avx512)
    return is_supported(InstructionSet::avx2) && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw");
#endif
  return set == InstructionSet::baseline;
}

/// The set with the widest vectors that this processor runs.
inline InstructionSet widest_instruction_set() {
  static const InstructionSet widest = is_supported(InstructionSet::avx512) ? InstructionSet::avx512
                                       : is_supported(InstructionSet::avx2)
                                           ? InstructionSet::avx2
                                           : InstructionSet::baseline;
  return widest;
}

}  // namespace sonde
