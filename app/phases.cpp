// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/phases.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "engine/study/charts/stacked_bars.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::app {
namespace {

/// The time of each phase, and last what is in none.
constexpr std::size_t part_count = phase_count + 1;

/// The names of the columns of times. They last: a column's name is a pointer.
const std::array<std::string, phase_count>& time_columns() {
  static const auto names = [] {
    std::array<std::string, phase_count> out;
    for (std::size_t i = 0; i < phase_count; ++i) out[i] = std::string(phase_names[i]) + "_us";
    return out;
  }();
  return names;
}

}  // namespace

void add_flags(CLI::App& parser, PhaseOptions& options) {
  parser.add_flag("--phases", options.columns,
                  "columns that say how an answer came about: the depth by translation alone "
                  "(pdt), converged, how many limits acted on the way (limited), and the time of "
                  "each phase (" +
                      time_columns().front() + " to " + time_columns().back() + ")");
  parser.add_option("--phases-picture", options.picture,
                    "file NAME.svg to write: the time of each phase, as bars");
}

std::vector<Column> with_phases(const PhaseOptions& options, std::vector<Column> columns) {
  if (!options.columns) return columns;
  columns.push_back({"pdt", "m"});
  if (options.with_converged) columns.push_back({"converged", ""});
  columns.push_back({"limited", ""});
  for (const std::string& name : time_columns()) columns.push_back({name.c_str(), "us"});
  return columns;
}

void append_phases(const PhaseOptions& options, Row& row, const Separation& answer) {
  if (!options.columns) return;
  if (answer.status == Status::failed) {
    append_nothing(row, options.with_converged ? 3 : 2);
  } else {
    row.push_back(answer.pdt ? Cell(*answer.pdt) : Cell());
    if (options.with_converged) row.push_back(answer.converged);
    row.push_back(std::int64_t{answer.limited});
  }
  // To the nanosecond: the clock knows no more.
  for (const double time : answer.phases.us) row.push_back(std::round(time * 1e3) / 1e3);
}

void check_picture(const PhaseOptions& options, const OutputOptions& output,
                   const std::vector<std::filesystem::path>& others) {
  check_beside(output, "--phases-picture", options.picture, others);
}

void PhasePicture::add(const Separation& answer, double time_us) {
  answers_.push_back({time_us, answer.status == Status::penetrating, answer.phases});
}

std::string PhasePicture::svg(const std::string& what) const {
  StackedBars chart{.title = "Where the time of " + what + " goes",
                    .label = "share of the mean time of threads, %",
                    .unit = "µs",
                    .part_names = {phase_names.begin(), phase_names.end()},
                    .bars = {}};
  chart.part_names.push_back("rest");
  const auto bar = [&](const std::string& name, std::span<const Answer> of) {
    if (of.empty()) return;
    StackedBars::Bar out{name, std::vector<double>(part_count)};
    const double share = 1 / static_cast<double>(of.size());
    for (const Answer& answer : of) {
      for (std::size_t i = 0; i < phase_count; ++i) out.parts[i] += share * answer.phases.us[i];
      // With two threads the phases may add up to more than the clock's time.
      out.parts.back() += share * std::max(0.0, answer.time_us - answer.phases.sum());
    }
    chart.bars.push_back(std::move(out));
  };
  std::vector<Answer> sorted = answers_;
  std::ranges::stable_sort(sorted, std::greater{}, &Answer::time_us);
  bar("all " + what, sorted);
  const auto free = std::stable_partition(sorted.begin(), sorted.end(),
                                          [](const Answer& answer) { return answer.penetrates; });
  const std::span<const Answer> deep(sorted.begin(), free);
  bar("in contact", deep);
  for (const auto& [name, part] : {std::pair{"slowest tenth of these", 10UL},
                                   {"slowest hundredth", 100UL},
                                   {"slowest thousandth", 1000UL}})
    if (deep.size() >= part) bar(name, deep.first(deep.size() / part));
  return to_svg(chart);
}

void PhasePicture::write_with(const PhaseOptions& options, const std::string& what,
                              const OutputOptions& output, const std::string& result) const {
  std::optional<PendingFile> picture;
  if (!options.picture.empty()) picture.emplace(options.picture, svg(what));
  write_result(output, result);
  if (picture) picture->commit();
}

}  // namespace sonde::app
