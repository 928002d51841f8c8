// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/baseline.hpp"

#include <array>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/text/number_text.hpp"

namespace sonde::bench {
namespace {

constexpr std::array<std::string_view, 3> sets{"avx512", "avx2", "baseline"};  // wide to narrow

nlohmann::json parsed(const std::string& text) {
  if (text.empty()) return nlohmann::json::object();
  const nlohmann::json out = nlohmann::json::parse(text, nullptr, false);
  if (!out.is_object()) throw InputError("not a baseline of the benchmarks: no JSON object");
  return out;
}

}  // namespace

Ratios ratios_of(const std::vector<Result>& results, const std::vector<Figure>& figures) {
  Ratios out;
  for (const Figure& figure : figures) {
    if (figure.against.empty() || figure.against.starts_with(ours)) continue;
    if (const std::optional<double> ratio = ratio_of(results, figure))
      out[figure.name + " / " + figure.against] = *ratio;
  }
  return out;
}

std::vector<std::string> slower_than(const Ratios& baseline, const Ratios& now) {
  std::vector<std::string> out;
  for (const auto& [name, before] : baseline) {
    const auto found = now.find(name);
    if (found == now.end())
      out.push_back(name + ": not measured");
    else if (!(found->second >= share_kept * before))
      out.push_back(name + ": " + number_text(found->second) + " times as fast, " +
                    number_text(before) + " in the baseline");
  }
  return out;
}

Ratios baseline_for(std::string_view instruction_set, const std::string& text) {
  const nlohmann::json all = parsed(text);
  bool as_wide = false;
  for (const std::string_view set : sets) {
    as_wide = as_wide || set == instruction_set;
    const auto found = all.find(set);
    if (!as_wide || found == all.end()) continue;
    try {
      return found->get<Ratios>();
    } catch (const nlohmann::json::exception&) {
      throw InputError("the baseline of " + std::string(set) + " holds something but numbers");
    }
  }
  throw InputError("no baseline for " + std::string(instruction_set) +
                   " or a narrower instruction set");
}

std::string with_baseline(std::string_view instruction_set, const Ratios& ratios,
                          const std::string& text) {
  nlohmann::json all = parsed(text);
  all[std::string(instruction_set)] = ratios;
  return all.dump(2) + "\n";
}

}  // namespace sonde::bench
