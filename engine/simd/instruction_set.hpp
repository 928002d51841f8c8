// SPDX-License-Identifier: GPL-3.0-or-later
// Which vector instructions kernels are compiled for, and which of them this processor runs. All
// kernels are chosen by it, so that a program runs one set; each gives the same bits.
#pragma once

// For __attribute__((target(...))) and the pragmas of lanes.hpp.
#define SONDE_TARGET_AVX2 "avx2"
#define SONDE_TARGET_AVX512 "avx512f,avx512vl,avx512dq,avx512bw"

namespace sonde {

/// In order: each has wider vectors than the last. The baseline is what the build is for.
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

/// The widest that this processor runs.
inline InstructionSet widest_instruction_set() {
  static const InstructionSet widest = is_supported(InstructionSet::avx512) ? InstructionSet::avx512
                                       : is_supported(InstructionSet::avx2)
                                           ? InstructionSet::avx2
                                           : InstructionSet::baseline;
  return widest;
}

}  // namespace sonde
