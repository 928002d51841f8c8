// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/compare_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "engine/study/charts/svg_chart.hpp"
#include "engine/study/comparison/claims.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;
using Value = std::function<double(const RenderedTick&)>;

constexpr std::size_t pdt_color = 1, pdg_color = 0, jump_color = 3;

ChartSeries curve(const std::string& name, const Rendering& rendering, const Value& value,
                  std::size_t color) {
  ChartSeries out{name};
  out.color = color;
  for (const RenderedTick& tick : rendering) {
    out.x.push_back(tick.t);
    out.y.push_back(tick.failed ? std::nan("") : value(tick));
  }
  return out;
}

/// The points on the curve at which the probe popped through.
ChartSeries pops(const std::string& name, const Rendering& rendering, const Value& value,
                 double radius, std::size_t color) {
  ChartSeries out{name};
  out.form = ChartSeries::Form::points;
  out.color = color;
  for (std::size_t i = 1; i < rendering.size(); ++i) {
    if (!popped_through(rendering[i - 1], rendering[i], radius)) continue;
    out.x.push_back(rendering[i].t);
    out.y.push_back(value(rendering[i - 1]));
  }
  if (out.x.empty()) out.name.clear();
  return out;
}

ChartPanel panel(const Comparison& c, const std::string& title, const std::string& unit,
                 const Value& value, double height) {
  ChartPanel out;
  out.title = title;
  out.x = {"time, s"};
  out.y = {unit};
  out.height = height;
  out.series = {curve("PD_t, clustered contacts", c.pdt, value, pdt_color),
                curve("PD_g", c.pdg, value, pdg_color),
                pops("PD_t pops through", c.pdt, value, c.radius, jump_color),
                pops("PD_g pops through", c.pdg, value, c.radius, jump_color + 1)};
  return out;
}

std::string wrench_picture(const Comparison& c) {
  SvgChart chart{c.scene + ": PD_t and PD_g on one device path", {}};
  const double tall = 190, low = 90;
  chart.panels.push_back(panel(
      c, "Force", "|F|, N", [](const auto& k) { return k.force.norm(); }, tall));
  chart.panels.push_back(panel(
      c, "Torque", "|τ|, N·m", [](const auto& k) { return k.torque.norm(); }, tall));
  chart.panels.push_back(panel(
      c, "Depth", "depth, m", [](const auto& k) { return k.depth; }, low));
  const char* axes = "xyz";
  for (int i = 0; i < 3; ++i)
    chart.panels.push_back(panel(
        c, std::string("Force along ") + axes[i], "N", [i](const auto& k) { return k.force[i]; },
        low));
  for (int i = 0; i < 3; ++i)
    chart.panels.push_back(panel(
        c, std::string("Torque about ") + axes[i], "N·m",
        [i](const auto& k) { return k.torque[i]; }, low));
  return to_svg(chart);
}

ChartPanel spectrum_panel(const Comparison& c, const std::string& title, const std::string& unit,
                          const std::function<Vec3(const RenderedTick&)>& value) {
  ChartPanel out;
  out.title = title;
  out.x = {"frequency, Hz", true};
  out.y = {unit, true};
  const auto add = [&](const char* name, const Rendering& rendering, std::size_t color) {
    std::vector<double> times;
    std::vector<Vec3> x;
    for (const RenderedTick& tick : rendering) {
      times.push_back(tick.t);
      x.push_back(value(tick));
    }
    const auto rate = sample_rate(times);
    if (!rate) return;
    const Spectrum s = spectrum(x, *rate);
    ChartSeries line{name, s.frequency, s.power};
    line.color = color;
    out.series.push_back(line);
  };
  add("PD_t, clustered contacts", c.pdt, pdt_color);
  add("PD_g", c.pdg, pdg_color);
  return out;
}

std::string spectrum_picture(const Comparison& c) {
  return to_svg(
      {c.scene + ": power by frequency",
       {spectrum_panel(c, "Force", "power, N²", [](const auto& k) { return k.force; }),
        spectrum_panel(c, "Torque", "power, (N·m)²", [](const auto& k) { return k.torque; })}});
}

void append_fields(std::string& line, const RenderedTick& k) {
  for (const double x :
       {k.force.x(), k.force.y(), k.force.z(), k.torque.x(), k.torque.y(), k.torque.z(), k.depth}) {
    line += ',';
    if (!k.failed) line += number_text(x, 17);
  }
  line.append(",").append(std::to_string(k.contacts));
  line.append(k.jumped ? ",1" : ",0").append(k.converged ? ",1" : ",0");
}

std::string wrench_csv(const Comparison& c) {
  std::string out = "t";
  for (const char* method : {"pdt", "pdg"})
    for (const char* column :
         {"fx", "fy", "fz", "tx", "ty", "tz", "depth", "contacts", "jumped", "converged"})
      out.append(",").append(method).append("_").append(column);
  out += "\n";
  for (std::size_t i = 0; i < c.pdt.size() && i < c.pdg.size(); ++i) {
    out += number_text(c.pdt[i].t, 17);
    append_fields(out, c.pdt[i]);
    append_fields(out, c.pdg[i]);
    out += "\n";
  }
  return out;
}

/// One line of the summary.
struct Measure {
  const char* key;
  const char* unit;
  const char* doc;
  std::function<std::optional<double>(const MethodMeasures&)> of;
};

std::optional<double> only_where(bool known, double value) {
  return known ? std::optional(value) : std::nullopt;
}

const std::vector<Measure>& measures() {
  using M = const MethodMeasures&;
  static const std::vector<Measure> all = {
      {"peak_force", "N", "largest force", [](M m) { return m.peak_force; }},
      {"peak_torque", "N*m", "largest torque", [](M m) { return m.peak_torque; }},
      {"deepest", "m", "largest depth", [](M m) { return m.deepest; }},
      {"force_variation", "N", "total variation of the force",
       [](M m) { return m.force_variation; }},
      {"torque_variation", "N*m", "total variation of the torque",
       [](M m) { return m.torque_variation; }},
      {"force_restlessness", "", "the same over the largest force",
       [](M m) { return m.force_restlessness(); }},
      {"torque_restlessness", "", "the same over the largest torque",
       [](M m) { return m.torque_restlessness(); }},
      {"force_above_50_hz", "", "share of the force's spectrum above 50 Hz",
       [](M m) { return m.force_above_50; }},
      {"torque_above_50_hz", "", "share of the torque's spectrum above 50 Hz",
       [](M m) { return m.torque_above_50; }},
      {"jumps", "", "jumps that the engine reports", [](M m) { return m.discontinuities.jumps; }},
      {"force_steps", "", "ticks with a step of the force",
       [](M m) { return m.discontinuities.force_steps; }},
      {"torque_steps", "", "ticks with a step of the torque",
       [](M m) { return m.discontinuities.torque_steps; }},
      {"largest_force_step", "N", "largest change of force in a tick",
       [](M m) { return m.discontinuities.largest_force_step; }},
      {"largest_torque_step", "N*m", "largest change of torque in a tick",
       [](M m) { return m.discontinuities.largest_torque_step; }},
      {"pop_throughs", "", "pop-throughs", [](M m) { return m.discontinuities.pop_throughs; }},
      {"analytic_ticks", "", "ticks compared with an analytic wrench",
       [](M m) { return static_cast<double>(m.realism.ticks); }},
      {"force_error", "", "median error of the force there, of its size",
       [](M m) {
         return only_where(m.realism.kind == AnalyticKind::half_space, m.realism.force_error);
       }},
      {"torque_error", "", "median error of the torque there, of force times radius",
       [](M m) { return only_where(m.realism.ticks > 0, m.realism.torque_error); }},
      {"worst_torque_error", "", "the worst of these",
       [](M m) { return only_where(m.realism.ticks > 0, m.realism.worst_torque_error); }},
      {"stable_stiffness", "N/m", "largest stable stiffness on the device, if one was named",
       [](M m) { return m.stiffness.stable; }},
      {"passive_stiffness", "N/m", "largest passive stiffness on it; 0: at none",
       [](M m) { return m.stiffness.passive; }},
      {"passive_stiffness_in_translation", "N/m", "the same with the turn of the handle held",
       [](M m) { return m.stiffness.passive_in_translation; }},
      {"cycle_lever", "J/(m rad)",
       "energy that a slow cycle can get, for each m of way and rad of half a turn's range",
       [](M m) { return only_where(m.stiffness.stable.has_value(), m.stiffness.cycle_lever); }},
      {"contact_ticks", "", "ticks with a force", [](M m) { return m.contact_ticks; }},
      {"saturated_ticks", "", "ticks beyond a limit of the device",
       [](M m) { return m.saturated_ticks; }},
      {"unconverged_ticks", "", "ticks whose way was blocked, or whose budget ran out",
       [](M m) { return m.unconverged_ticks; }},
      {"failed_ticks", "", "ticks without an answer", [](M m) { return m.failed_ticks; }},
  };
  return all;
}

Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string summary_json(const Comparison& c) {
  Json units = Json::object(), pdt = Json::object(), pdg = Json::object(), said = Json::object();
  for (const Measure& m : measures()) {
    if (*m.unit != 0) units[m.key] = m.unit;
    pdt[m.key] = number_or_null(m.of(c.of_pdt));
    pdg[m.key] = number_or_null(m.of(c.of_pdg));
  }
  Json tested = Json::object();
  for (const TestedClaim& claim : tested_claims(c)) {
    said[claim.key] = name_of(claim.finding);
    tested[claim.key] = {{"finding", name_of(claim.finding)},
                         {"for", claim.for_it},
                         {"against", claim.against_it},
                         {"alike", claim.alike},
                         {"chance", claim.chance}};
  }
  const Json all{{"scene", c.scene},
                 {"stiffness", c.stiffness},
                 {"units", units},
                 {"pdt", pdt},
                 {"pdg", pdg},
                 {"pdg_claims", said},
                 {"pdg_claims_tested", tested}};
  return all.dump(2) + "\n";
}

std::string text_of(const std::optional<double>& value, int digits) {
  return value ? number_text(*value, digits) : std::string();
}

std::string summary_csv(const Comparison& c) {
  std::string out = "measure,unit,pdt,pdg\n";
  for (const Measure& m : measures())
    out += std::string(m.key) + "," + m.unit + "," + text_of(m.of(c.of_pdt), 17) + "," +
           text_of(m.of(c.of_pdg), 17) + "\n";
  return out;
}

/// Empty if the path is evenly sampled.
std::string about_gaps(const Comparison& c) {
  std::vector<double> times;
  for (const RenderedTick& tick : c.pdg) times.push_back(tick.t);
  if (times.size() < 2 || sample_rate(times)) return {};
  double longest = 0;
  for (std::size_t i = 1; i < times.size(); ++i)
    longest = std::max(longest, times[i] - times[i - 1]);
  return " The path is not evenly sampled: up to " + number_text(longest, 3) +
         " s lie between two rows. There is no share above 50 Hz, and steps and jumps may be the "
         "gaps'.";
}

std::string summary_md(const Comparison& c) {
  std::string out = "# " + c.scene + ": PD_t beside PD_g\n\nOne device path of " +
                    std::to_string(c.pdg.size()) + " ticks, " + number_text(c.stiffness, 4) +
                    " N/m." + about_gaps(c) + "\n\n| | unit | PD_t | PD_g |\n|---|---|---|---|\n";
  for (const Measure& m : measures())
    out += std::string("| ") + m.doc + " | " + m.unit + " | " + text_of(m.of(c.of_pdt), 4) + " | " +
           text_of(m.of(c.of_pdg), 4) + " |\n";
  out +=
      "\n| of PD_g, as compared with PD_t | | for | against | chance |\n|---|---|---:|---:|---:|\n";
  for (const TestedClaim& claim : tested_claims(c))
    out += std::string("| ") + claim.claim + " | " + name_of(claim.finding) + " | " +
           std::to_string(claim.for_it) + " | " + std::to_string(claim.against_it) + " | " +
           number_text(claim.chance, 2) + " |\n";
  return out;
}

}  // namespace

std::vector<StudyFile> compare_files(const Comparison& comparison) {
  return {
      {"wrench.svg", wrench_picture(comparison)}, {"spectrum.svg", spectrum_picture(comparison)},
      {"wrench.csv", wrench_csv(comparison)},     {"summary.json", summary_json(comparison)},
      {"summary.csv", summary_csv(comparison)},   {"summary.md", summary_md(comparison)}};
}

std::vector<StudyFile> compare_files(const std::string& folder, const StudyFolder& study) {
  return compare_files(comparison_of(folder, study));
}

}  // namespace sonde
