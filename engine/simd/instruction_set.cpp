// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/simd/instruction_set.hpp"

#include <cstdlib>
#include <optional>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

constexpr const char* variable = "SONDE_INSTRUCTION_SET";

InstructionSet widest() noexcept {
  for (const InstructionSet set : {InstructionSet::avx512, InstructionSet::avx2})
    if (is_supported(set)) return set;
  return InstructionSet::baseline;
}

std::optional<InstructionSet> named(std::string_view name) noexcept {
  for (int i = 0; i < static_cast<int>(InstructionSet::count); ++i)
    if (name == name_of(static_cast<InstructionSet>(i))) return static_cast<InstructionSet>(i);
  return std::nullopt;
}

}  // namespace

std::string_view name_of(InstructionSet set) noexcept {
  constexpr std::string_view names[] = {"baseline", "avx2", "avx512"};
  return names[static_cast<int>(set)];
}

bool is_supported(InstructionSet set) noexcept {
#ifdef __x86_64__
  if (set == InstructionSet::avx2) return __builtin_cpu_supports("avx2");
  if (set == InstructionSet::avx512)
    return is_supported(InstructionSet::avx2) && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw");
#endif
  return set == InstructionSet::baseline;
}

InstructionSet chosen_instruction_set() noexcept {
  const char* const name = std::getenv(variable);
  const std::optional<InstructionSet> set = name ? named(name) : std::nullopt;
  return set && is_supported(*set) ? *set : widest();
}

void check_instruction_set() {
  const char* const name = std::getenv(variable);
  if (!name) return;
  const std::string value = std::string(variable) + "=" + name;
  const std::optional<InstructionSet> set = named(name);
  if (!set) throw InputError(value + ": the sets are baseline, avx2 and avx512");
  if (!is_supported(*set)) throw InputError(value + ": this processor does not run it");
}

}  // namespace sonde
