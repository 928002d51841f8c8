// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/traces_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "engine/base/error.hpp"
#include "engine/study/charts/small_multiples.hpp"
#include "engine/study/stability/hand_course.hpp"
#include "engine/study/stability/press_and_hold.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double newton_metres_to_milli = 1e3, metres_to_milli = 1e3;

/// The result of one part.
struct Trace {
  std::string course;
  double stiffness = 0, damping = 0;
  double force = 0, overshoot = 0, energy = 0, chatter = 0;
  int jumps = 0, failures = 0;
  std::optional<double> settling_time;
  std::vector<std::array<double, 8>> samples;  ///< t, fx, fy, fz, tx, ty, tz, depth
};

Trace trace_in(const std::string& text) {
  const Json json = Json::parse(text);
  Trace out;
  out.course = json.at("course").get<std::string>();
  const std::pair<const char*, double*> numbers[] = {
      {"stiffness", &out.stiffness}, {"damping", &out.damping}, {"force", &out.force},
      {"overshoot", &out.overshoot}, {"energy", &out.energy},   {"chatter", &out.chatter}};
  for (const auto& [key, to] : numbers) *to = json.at(key).get<double>();
  out.jumps = json.at("jumps").get<int>();
  out.failures = json.at("failures").get<int>();
  const Json& settling = json.at("settling_time");
  if (!settling.is_null()) out.settling_time = settling.get<double>();
  out.samples = json.at("samples").get<std::vector<std::array<double, 8>>>();
  return out;
}

std::vector<Trace> traces_in(const std::string& folder, const StudyFolder& study) {
  std::vector<Trace> out;
  for (std::size_t i = 0; i < study.names.size(); ++i) {
    if (!study.results[i])
      throw InputError::in(folder, "the part " + study.names[i] + " is missing");
    try {
      out.push_back(trace_in(*study.results[i]));
    } catch (const nlohmann::json::exception&) {
      throw InputError::in(folder, "the part " + study.names[i] + " was not written by a study");
    }
  }
  return out;
}

std::string table(const std::vector<Trace>& traces) {
  std::string out = "course,k,b,t,fx,fy,fz,tx,ty,tz,depth\n";
  for (const Trace& trace : traces) {
    const std::string head =
        trace.course + "," + number_text(trace.stiffness) + "," + number_text(trace.damping);
    for (const auto& sample : trace.samples) {
      out += head;
      for (const double value : sample) out.append(1, ',').append(number_text(value));
      out += "\n";
    }
  }
  return out;
}

std::string summary_table(const std::vector<Trace>& traces) {
  std::string out = "course,k,b,force,settling_time,overshoot,energy,chatter,jumps,failures\n";
  for (const Trace& t : traces)
    out += t.course + "," + number_text(t.stiffness) + "," + number_text(t.damping) + "," +
           number_text(t.force) + "," + (t.settling_time ? number_text(*t.settling_time) : "") +
           "," + number_text(t.overshoot) + "," + number_text(t.energy) + "," +
           number_text(t.chatter) + "," + std::to_string(t.jumps) + "," +
           std::to_string(t.failures) + "\n";
  return out;
}

/// Three digits, without an exponent where a person would write none.
std::string figures_text(double value) {
  return number_text(parse_number(number_text(value, 3)).value_or(value));
}

bool buzzes(const Trace& t) { return t.chatter > 0; }

/// A short text for the figures.
std::string note(const Trace& t) {
  if (t.failures > 0) return std::to_string(t.failures) + " ticks without an answer";
  if (!(t.force > 0)) return "out of contact";
  const std::string over = figures_text(std::round(1000 * t.overshoot) / 10) + " % over";
  if (buzzes(t)) return "buzzes, " + over;
  if (t.jumps > 0) return "slips to another place";
  if (!t.settling_time) return "does not settle, " + over;
  return "settles in " + figures_text(1e3 * *t.settling_time) + " ms, " + over;
}

std::string summary_page(const Json& about, const std::vector<Trace>& traces) {
  std::string out = "A " + about.at("situation").get<std::string>() + " contact on " +
                    about.at("device").at("name").get<std::string>() + ".";
  if (!about.at("theory_stable").is_null())
    out += " Theory allows k = " + figures_text(about.at("theory_stable").get<double>()) +
           " N/m without damping.";
  out +=
      "\n\n| course | k, N/m | b, N·s/m | force, N | what it does | energy to the hand, mJ |\n"
      "|---|---:|---:|---:|---|---:|\n";
  for (const Trace& t : traces)
    out += "| " + t.course + " | " + figures_text(t.stiffness) + " | " + figures_text(t.damping) +
           " | " + figures_text(t.force) + " | " + note(t) + " | " + figures_text(1e3 * t.energy) +
           " |\n";
  return out;
}

ChartTableCell cell_of(const Trace& trace) {
  ChartTableCell cell{
      {}, std::vector<std::vector<double>>(3), note(trace), buzzes(trace) || trace.failures > 0};
  for (const auto& s : trace.samples) {
    cell.x.push_back(s[0]);
    cell.y[0].push_back(Vec3(s[1], s[2], s[3]).norm());
    cell.y[1].push_back(newton_metres_to_milli * Vec3(s[4], s[5], s[6]).norm());
    cell.y[2].push_back(metres_to_milli * s[7]);
  }
  return cell;
}

SmallMultiples empty_picture(const Json& about, const std::vector<double>& stiffness) {
  SmallMultiples out{.title = about.at("device").at("name").get<std::string>() + ", " +
                              about.at("situation").get<std::string>() + " contact",
                     .x_label = "time, s",
                     .quantities = {{"force, N"}, {"torque, mN·m"}, {"depth, mm"}}};
  for (const double k : stiffness) out.rows.push_back("k = " + figures_text(k) + " N/m");
  return out;
}

/// Parts are ordered by course, then by stiffness, then by damping. A picture has a row for each
/// stiffness and a column for each damping, with some of the courses side by side.
StudyFile picture(const std::string& file, const Json& about, const std::vector<Trace>& traces,
                  std::span<const HandCourse> courses) {
  const auto stiffness = about.at("stiffness").get<std::vector<double>>();
  const auto damping = about.at("damping").get<std::vector<double>>();
  const std::size_t each = stiffness.size() * damping.size();
  const bool names_damping = damping.size() > 1, names_course = courses.size() > 1;
  SmallMultiples out = empty_picture(about, stiffness);
  if (!names_course) out.title += std::string(", ") + name_of(courses[0]);
  for (const HandCourse course : courses)
    for (const double b : damping) {
      std::string column = names_course ? name_of(course) : "";
      if (names_damping) column += (names_course ? ", b = " : "b = ") + figures_text(b) + " N·s/m";
      out.columns.push_back(column);
    }
  for (std::size_t k = 0; k < stiffness.size(); ++k)
    for (const HandCourse course : courses) {
      const auto which = static_cast<std::size_t>(std::ranges::find(all_hand_courses, course) -
                                                  std::begin(all_hand_courses));
      for (std::size_t b = 0; b < damping.size(); ++b)
        out.cells.push_back(cell_of(traces.at(which * each + k * damping.size() + b)));
    }
  return {file, to_svg(out)};
}

std::vector<StudyFile> pictures(const Json& about, const std::vector<Trace>& traces) {
  std::vector<StudyFile> out{picture("traces.svg", about, traces, all_hand_courses)};
  if (about.at("damping").size() == 1) return out;
  for (const HandCourse& course : all_hand_courses)
    out.push_back(picture(std::string("traces-") + name_of(course) + ".svg", about, traces,
                          std::span(&course, 1)));
  return out;
}

}  // namespace

std::vector<StudyFile> traces_files(const std::string& folder, const StudyFolder& study) {
  const std::vector<Trace> traces = traces_in(folder, study);
  const Json about = Json::parse(study.about);
  std::vector<StudyFile> out{{"traces.csv", table(traces)},
                             {"summary.csv", summary_table(traces)},
                             {"summary.md", summary_page(about, traces)}};
  for (StudyFile& picture : pictures(about, traces)) out.push_back(std::move(picture));
  return out;
}

}  // namespace sonde
