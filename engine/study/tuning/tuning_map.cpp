// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"
#include "engine/study/charts/svg_chart.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

constexpr std::array class_names{"unstable", "saturated", "chattering", "stable", "passive"};
const std::vector<ChartCellKind> class_colors{{"unstable", "#d7301f"},   {"saturated", "#fdae61"},
                                              {"chattering", "#fee391"}, {"stable", "#c7e9c0"},
                                              {"passive", "#74c476"},    {"not run", "#ffffff"}};

/// The stiffness of a limit; infinite if none was searched for, or found.
double end_of(const std::optional<SweepLimit>& limit) {
  return limit && limit->fault != HoldFault::none ? limit->stiffness
                                                  : std::numeric_limits<double>::infinity();
}

/// The range of stiffness that one run represents: half-way, in ratio, to its neighbours.
struct Stretch {
  double from, to;
  MapClass map_class;
};

void add(std::vector<Stretch>& stretches, const Stretch& next) {
  if (!stretches.empty() && stretches.back().map_class == next.map_class)
    stretches.back().to = next.to;
  else
    stretches.push_back(next);
}

std::vector<Stretch> stretches(const TuningColumn& column) {
  std::vector<Stretch> out;
  const auto& runs = column.runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double own = runs[i].stiffness;
    const double from = i == 0 ? own : std::sqrt(runs[i - 1].stiffness * own);
    const double to = i + 1 == runs.size() ? own : std::sqrt(runs[i + 1].stiffness * own);
    const MapClass map_class = class_of(runs[i], column.theory_passive);
    const double passive = column.theory_passive;
    // Theory gives a finer boundary.
    if (map_class >= MapClass::stable && from < passive && passive < to) {
      add(out, {from, passive, MapClass::passive});
      add(out, {passive, to, MapClass::stable});
    } else {
      add(out, {from, to, map_class});
    }
  }
  return out;
}

MapClass class_at(const TuningColumn& column, double stiffness) {
  const auto nearest = std::ranges::min_element(column.runs, {}, [&](const SweepPoint& run) {
    return std::abs(elementary::log(run.stiffness / stiffness));
  });
  return class_of(*nearest, column.theory_passive);
}

std::vector<const TuningLine*> nominal_lines(const TuningResults& results, GainAxis axis) {
  std::vector<const TuningLine*> out;
  for (const TuningLine& line : results.lines)
    if (line.assumed.empty() && line.axis == axis) out.push_back(&line);
  return out;
}

const char* unit_of(GainAxis axis) { return axis == GainAxis::rotation ? "N·m/rad" : "N/m"; }
std::string stiffness_label(GainAxis axis) {
  return std::string("stiffness ") + stiffness_key(axis) + ", " + unit_of(axis);
}

ChartSeries step(const std::string& name, std::size_t color, ChartSeries::Form form) {
  return {name, {}, {}, form, color};
}
/// A vertical stroke of a line that is interrupted between rows.
void stroke(ChartSeries& series, double x, double y_from, double y_to) {
  const double gap = std::numeric_limits<double>::quiet_NaN();
  series.x.insert(series.x.end(), {x, x, gap});
  series.y.insert(series.y.end(), {y_from, y_to, gap});
}

/// An important remark: theory has no friction.
std::string remark(const AxisGains& gains) {
  if (gains.stiffness <= gains.theory) return {};
  return "; the recommendation is above the limit in theory, which has no friction";
}

void add_recommended(ChartPanel& panel, const TuningResults& results, GainAxis axis, double from,
                     double to) {
  const auto gains = recommend(results, axis);
  if (!gains || gains->stiffness <= 0) return;
  panel.title += remark(*gains);
  panel.series.push_back({"recommended",
                          {gains->stiffness, gains->stiffness},
                          {from, to},
                          ChartSeries::Form::line,
                          0});
}

/// Rows: by situation, then by hand.
ChartPanel object_panel(const TuningResults& results) {
  const auto lines = nominal_lines(results, GainAxis::object);
  ChartPanel panel;
  panel.title = "Holds in each contact, with each hand";
  panel.x = {stiffness_label(GainAxis::object), true};
  panel.y = {"", false, 0.0, double(lines.size())};
  panel.kinds = class_colors;
  panel.height = 34 * double(lines.size()) + 40;
  ChartSeries measured = step("measured limit of stability", 7, ChartSeries::Form::line);
  ChartSeries theory = step("limit in theory", 1, ChartSeries::Form::dashed);
  ChartSeries passive = step("passive in theory", 2, ChartSeries::Form::dashed);
  ChartSeries frictionless = step("limit without friction", 4, ChartSeries::Form::line);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const TuningColumn& column = lines[i]->columns.front();
    const double row = double(i);
    panel.y.names.push_back(lines[i]->kind + ",\n" + lines[i]->hand + " hand");
    for (const Stretch& s : stretches(column))
      panel.cells.push_back({s.from, s.to, row, row + 1, static_cast<std::size_t>(s.map_class)});
    stroke(measured, column.stable.stiffness, row, row + 1);
    stroke(theory, column.theory_stable, row, row + 1);
    stroke(passive, column.theory_passive, row, row + 1);
    stroke(frictionless, end_of(column.without_friction), row, row + 1);
  }
  panel.series = {measured, theory, passive, frictionless};
  add_recommended(panel, results, GainAxis::object, 0, double(lines.size()));
  return panel;
}

/// The edges between neighbouring dampings, and the outer ones: half-way on a linear scale.
std::vector<double> damping_edges(const std::vector<double>& values) {
  std::vector<double> out{values.front()};
  for (std::size_t i = 1; i < values.size(); ++i) out.push_back((values[i - 1] + values[i]) / 2);
  out.push_back(values.size() > 1 ? values.back() : values.back() + 1);
  return out;
}

/// The same for stiffnesses: half-way on a logarithmic scale.
std::vector<double> stiffness_edges(const std::vector<double>& values) {
  std::vector<double> out{values.front()};
  for (std::size_t i = 1; i < values.size(); ++i)
    out.push_back(std::sqrt(values[i - 1] * values[i]));
  out.push_back(values.back());
  return out;
}

std::vector<double> dampings_of(const std::vector<const TuningLine*>& lines) {
  std::vector<double> out;
  for (const TuningColumn& column : lines.front()->columns)
    if (std::ranges::all_of(lines, [&](const TuningLine* line) {
          return std::ranges::find(line->columns, column.damping, &TuningColumn::damping) !=
                 line->columns.end();
        }))
      out.push_back(column.damping);
  return out;
}

/// The columns of every line at one damping.
std::vector<const TuningColumn*> columns_at(const std::vector<const TuningLine*>& lines,
                                            double damping) {
  std::vector<const TuningColumn*> out;
  out.reserve(lines.size());
  for (const TuningLine* line : lines)
    out.push_back(&*std::ranges::find(line->columns, damping, &TuningColumn::damping));
  return out;
}

void add_cells(ChartPanel& panel, const std::vector<const TuningColumn*>& columns, double from,
               double to) {
  std::vector<double> values;
  for (const TuningColumn* column : columns)
    for (const SweepPoint& run : column->runs) values.push_back(run.stiffness);
  ordering::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  const std::vector<double> sides = stiffness_edges(values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    MapClass worst = MapClass::passive;
    for (const TuningColumn* column : columns)
      worst = std::min(worst, class_at(*column, values[i]));
    const auto kind = static_cast<std::size_t>(worst);
    if (i > 0 && panel.cells.back().kind == kind)
      panel.cells.back().x_to = sides[i + 1];
    else
      panel.cells.push_back({sides[i], sides[i + 1], from, to, kind});
  }
}

std::string title_of(const TuningResults& results, GainAxis axis) {
  if (axis == GainAxis::damped) return "Damped object norm, worst of all situations";
  if (axis == GainAxis::translation) return "Translation alone, worst of all situations";
  if (axis == GainAxis::rotation) return "Rotation alone, worst of all situations";
  const std::string springs =
      ", worst of all situations; k_r = " + number_text(results.joint.stiffness, 3) + " m² k_t";
  if (axis == GainAxis::together_b_t) return "Both springs with b_t by itself" + springs;
  if (axis == GainAxis::together_b_r) return "Both springs with b_r by itself" + springs;
  return "All gains together" + springs + ", b_r = " + number_text(results.joint.damping, 3) +
         " m² b_t";
}

/// Stiffness against damping, the worst of all situations.
ChartPanel classic_panel(const TuningResults& results, GainAxis axis) {
  const auto lines = nominal_lines(results, axis);
  const bool turns = axis == GainAxis::rotation;
  ChartPanel panel;
  panel.title = title_of(results, axis);
  panel.x = {stiffness_label(axis), true};
  panel.y = {damps_turns(axis) ? "damping b_r, N·m·s/rad" : "damping b_t, N·s/m"};
  panel.kinds = class_colors;
  ChartSeries measured = step("measured limit of stability", 7, ChartSeries::Form::line);
  ChartSeries theory = step("limit in theory", 1, ChartSeries::Form::dashed);
  ChartSeries passive = step("passive in theory", 2, ChartSeries::Form::dashed);
  ChartSeries frictionless = step("limit without friction", 4, ChartSeries::Form::line);
  const std::vector<double> dampings = dampings_of(lines);
  const std::vector<double> sides = damping_edges(dampings);
  for (std::size_t i = 0; i < dampings.size(); ++i) {
    const auto columns = columns_at(lines, dampings[i]);
    add_cells(panel, columns, sides[i], sides[i + 1]);
    const auto least = [&](const auto& of) {
      double out = std::numeric_limits<double>::infinity();
      for (const TuningColumn* column : columns) out = std::min(out, of(*column));
      return out;
    };
    const auto add = [&](ChartSeries& series, double x) {
      series.x.push_back(x);
      series.y.push_back(dampings[i]);
    };
    add(measured, least([](const TuningColumn& c) { return c.stable.stiffness; }));
    add(theory, least([](const TuningColumn& c) { return c.theory_stable; }));
    add(passive, least([](const TuningColumn& c) { return c.theory_passive; }));
    // If it was searched for in only some contacts, their minimum would be misleading.
    if (std::ranges::all_of(columns, [](const TuningColumn* c) { return !!c->without_friction; }))
      add(frictionless, least([](const TuningColumn& c) { return end_of(c.without_friction); }));
  }
  frictionless.form = ChartSeries::Form::points;  // only few dampings have one
  panel.series = {measured, theory, passive};
  if (!frictionless.x.empty()) panel.series.push_back(frictionless);
  const Coupling gains = recommended_coupling(results);
  const bool recommended = recommended_axes(results).front() == axis;
  if ((is_joint(axis) || axis == GainAxis::damped) && recommended && has_recommendation(results))
    panel.title += remark(*recommend(results, axis));
  if (has_recommendation(results) && (recommended || !is_joint(axis)))
    panel.series.push_back({"recommended",
                            {in_object_norm(axis) ? gains.k
                             : turns              ? gains.k_r
                                                  : gains.k_t},
                            {damps_turns(axis) ? gains.b_r : gains.b_t},
                            ChartSeries::Form::points,
                            0});
  return panel;
}

/// The error of the wrench in every situation, without damping.
ChartPanel fidelity_panel(const TuningResults& results, GainAxis axis, bool turns) {
  ChartPanel panel;
  panel.title = turns ? "Torque against what is commanded" : "Force against what is commanded";
  panel.x = {stiffness_label(axis), true};
  panel.y = {turns ? "torque error (share)" : "force error (share)", true};
  for (const TuningLine* line : nominal_lines(results, axis)) {
    ChartSeries series{line->kind + " " + line->hand, {}, {}, ChartSeries::Form::line, {}};
    for (const SweepPoint& run : line->columns.front().runs) {
      series.x.push_back(run.stiffness);
      series.y.push_back(turns ? run.report.torque_error : run.report.force_error);
    }
    panel.series.push_back(series);
  }
  return panel;
}

}  // namespace

const char* name_of(MapClass map_class) { return class_names[static_cast<std::size_t>(map_class)]; }

MapClass class_of(const SweepPoint& run, double passive) {
  if (!run.report.stable) return MapClass::unstable;
  if (run.report.saturated) return MapClass::saturated;
  if (run.report.chattering) return MapClass::chattering;
  return run.stiffness <= passive ? MapClass::passive : MapClass::stable;
}

std::string map_csv(const TuningResults& results) {
  std::string out =
      "situation,kind,hand,axis,assumed,times,damping,stiffness,class,stable,passive,chattering,"
      "saturated,growth,chatter,saturation,work,force_error,torque_error,depth,contact,force,"
      "torque,jumps,pop_throughs,theory_stable,theory_passive,stable_without_friction,"
      "stable_at_harder_knocks\n";
  for (const TuningLine& line : results.lines)
    for (const TuningColumn& column : line.columns)
      for (const SweepPoint& run : column.runs) {
        const HoldReport& r = run.report;
        out += std::to_string(line.situation) + "," + line.kind + "," + line.hand + "," +
               name_of(line.axis) + "," + line.assumed;
        const auto add = [&](double x) {
          out += ',';
          if (std::isfinite(x)) out += number_text(x);
        };
        for (const double x : {line.times, column.damping, run.stiffness}) add(x);
        out += std::string(",") + name_of(class_of(run, column.theory_passive));
        for (const bool is :
             {r.stable, run.stiffness <= column.theory_passive, r.chattering, r.saturated})
          out += is ? ",1" : ",0";
        for (const double x : {r.growth, r.chatter, r.saturation, r.work, r.force_error,
                               r.torque_error, r.depth, r.contact, r.force, r.torque})
          add(x);
        add(r.jumps);
        add(r.pop_throughs);
        add(column.theory_stable);
        add(column.theory_passive);
        add(end_of(column.without_friction));
        add(end_of(column.harder_knocks));
        out += "\n";
      }
  return out;
}

std::string map_svg(const TuningResults& results) {
  SvgChart chart;
  chart.title = "Stability of " + results.device_id;
  for (const GainAxis axis : axes_of(results)) {
    chart.panels.push_back(axis == GainAxis::object ? object_panel(results)
                                                    : classic_panel(results, axis));
    const auto joint = joint_axes(results);
    if (is_joint(axis) && axis != joint.front()) continue;  // the same springs
    if (axis != GainAxis::rotation) chart.panels.push_back(fidelity_panel(results, axis, false));
    if (axis != GainAxis::translation) chart.panels.push_back(fidelity_panel(results, axis, true));
  }
  return to_svg(chart);
}

}  // namespace sonde
