// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/stability_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/numbers.hpp"

namespace sonde::ui {
namespace {

using Lines = std::vector<const TuningLine*>;
using Columns = std::vector<const TuningColumn*>;

/// A run speaks for what is nearer to it than to another, by ratio.
MapClass class_at(const TuningColumn& column, double stiffness) {
  const auto nearest = std::ranges::min_element(column.runs, {}, [&](const SweepPoint& run) {
    return std::abs(std::log(run.stiffness / stiffness));
  });
  return class_of(*nearest, column.theory_passive);
}

/// Where one run's word ends and the next one's begins, and the ends of all.
std::vector<double> edges_of(const Columns& columns, double low, double high) {
  std::vector<double> edges{low, high};
  for (const TuningColumn* column : columns)
    for (std::size_t i = 1; i < column->runs.size(); ++i)
      edges.push_back(std::sqrt(column->runs[i - 1].stiffness * column->runs[i].stiffness));
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

MapRow worst_of(const Columns& columns, double low, double high) {
  MapRow row;
  row.damping = columns.front()->damping;
  row.stable = row.theory_stable = row.theory_passive = infinity;
  for (const TuningColumn* column : columns) {
    row.stable = std::min(row.stable, column->stable.stiffness);
    row.theory_stable = std::min(row.theory_stable, column->theory_stable);
    row.theory_passive = std::min(row.theory_passive, column->theory_passive);
  }
  const std::vector<double> edges = edges_of(columns, low, high);
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const double middle = std::sqrt(edges[i - 1] * edges[i]);
    MapClass worst = MapClass::passive;
    for (const TuningColumn* column : columns) worst = std::min(worst, class_at(*column, middle));
    if (!row.stretches.empty() && row.stretches.back().map_class == worst)
      row.stretches.back().to = edges[i];
    else
      row.stretches.push_back({edges[i - 1], edges[i], worst});
  }
  return row;
}

const TuningColumn* column_at(const TuningLine& line, double damping) {
  const auto found = std::ranges::find(line.columns, damping, &TuningColumn::damping);
  return found == line.columns.end() || found->runs.empty() ? nullptr : &*found;
}

/// A row for each damping that every line has.
void add_dampings(const Lines& lines, StabilityMap& map) {
  std::vector<MapRow>& rows = map.rows;
  for (const TuningColumn& first : lines.front()->columns) {
    Columns columns;
    for (const TuningLine* line : lines)
      if (const TuningColumn* own = column_at(*line, first.damping)) columns.push_back(own);
    if (columns.size() == lines.size()) rows.push_back(worst_of(columns, map.low, map.high));
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double own = rows[i].damping;
    rows[i].from = i == 0 ? own : rows[i - 1].to;
    rows[i].to = i + 1 < rows.size() ? (own + rows[i + 1].damping) / 2 : own;
  }
}

void add_situations(const Lines& lines, StabilityMap& map) {
  for (const TuningLine* line : lines) {
    if (line->columns.empty() || line->columns.front().runs.empty()) continue;
    MapRow row = worst_of({&line->columns.front()}, map.low, map.high);
    row.from = double(map.rows.size());
    row.to = row.from + 1;
    row.kind = line->kind;
    row.label = QString::fromStdString(line->kind + ", " + line->hand);
    map.rows.push_back(row);
  }
}

void find_range(const Lines& lines, StabilityMap& map) {
  double low = infinity, high = 0;
  for (const TuningLine* line : lines)
    for (const TuningColumn& column : line->columns)
      for (const SweepPoint& run : column.runs) {
        low = std::min(low, run.stiffness);
        high = std::max(high, run.stiffness);
      }
  if (!(low > 0 && low < high)) return;
  map.low = low;
  map.high = high;
}

}  // namespace

StabilityMap stability_map(const TuningResults& results, GainAxis axis, const std::string& kind) {
  StabilityMap map{.axis = axis, .over_damping = false, .rows = {}};
  Lines lines;
  for (const TuningLine& line : results.lines)
    if (line.axis == axis && line.assumed.empty() && (kind.empty() || line.kind == kind))
      lines.push_back(&line);
  if (lines.empty()) return map;
  find_range(lines, map);
  map.over_damping =
      std::ranges::all_of(lines, [](const TuningLine* line) { return line->columns.size() > 1; });
  if (map.over_damping)
    add_dampings(lines, map);
  else
    add_situations(lines, map);
  return map;
}

MapPoint point_of(const Coupling& gains, GainAxis axis) {
  if (axis == GainAxis::object) return {gains.k, 0};
  if (axis == GainAxis::damped) return {gains.k, gains.b_t};
  return {axis == GainAxis::rotation ? gains.k_r : gains.k_t,
          damps_turns(axis) ? gains.b_r : gains.b_t};
}

std::vector<std::string> kinds_of(const TuningResults& results) {
  std::vector<std::string> out;
  for (const TuningLine& line : results.lines)
    if (std::ranges::find(out, line.kind) == out.end()) out.push_back(line.kind);
  return out;
}

QString stiffness_unit(GainAxis axis) {
  return axis == GainAxis::rotation ? QStringLiteral("N·m/rad") : QStringLiteral("N/m");
}

QString damping_unit(GainAxis axis) {
  return damps_turns(axis) ? QStringLiteral("N·m·s/rad") : QStringLiteral("N·s/m");
}

}  // namespace sonde::ui
