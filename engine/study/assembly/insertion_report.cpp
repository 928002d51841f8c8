// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/insertion_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/queries/body_queries.hpp"
#include "engine/study/charts/svg_chart.hpp"
#include "engine/text/csv_word.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr double to_mm = 1e3, to_degrees = 180 / std::numbers::pi;
constexpr const char* kind_of_study = "insert";
constexpr const char* columns =
    "travel,px,py,pz,qw,qx,qy,qz,clearance,depth,fx,fy,fz,tx,ty,tz,x,y,z,nx,ny,nz,multiplier,"
    "contacts,part";
constexpr std::size_t count_of_columns = 25;

/// The contact with the largest multiplier; if the probe is free, the closest points. At the first
/// contact these are so close that rounding turns their direction: that is the first contact's.
Contact binding(const InsertionStep& step, const std::optional<FirstContact>& first) {
  Contact out;
  if (step.held.contacts.size > 0)
    return *std::max_element(
        step.held.contacts.begin(), step.held.contacts.end(),
        [](const Contact& a, const Contact& b) { return a.multiplier < b.multiplier; });
  if (first && step.travel == first->travel) return first->contact;
  const Clearance& c = step.clearance;
  out.on_fixed = c.on_fixed;
  out.on_probe = c.on_probe;
  const Vec3 gap = c.on_probe - c.on_fixed;
  out.normal = gap.squaredNorm() > 0 ? Vec3(gap.stableNormalized()) : Vec3(Vec3::Zero());
  return out;
}

/// The name of the part of the fixed body at a point; null if the body is of one mesh.
Json part_of_fixed(const Body& fixed, const Vec3& x) {
  return fixed.parts.empty() ? Json() : Json(utf8_text(part_at(fixed, x)));
}

Json row_of(const InsertionStep& step, const std::optional<FirstContact>& first,
            const Body& fixed) {
  const auto& [q, p] = step.X_FM;
  const Contact c = binding(step, first);
  Json row{step.travel, p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
  row.push_back(step.clearance.overlapping ? Json() : Json(step.clearance.distance));
  row.push_back(step.held.status == Status::failed ? Json() : Json(step.held.depth));
  for (const Vec3& v : {step.wrench.force, step.wrench.torque, c.on_fixed, c.normal})
    for (const double x : {v.x(), v.y(), v.z()}) row.push_back(x);
  row.push_back(c.multiplier);
  row.push_back(step.held.contacts.size);
  row.push_back(part_of_fixed(fixed, c.on_fixed));
  return row;
}

Json first_of(const std::optional<FirstContact>& first, const Body& fixed) {
  if (!first) return nullptr;
  const auto& [q, p] = first->X_FM;
  const Vec3 &at = first->contact.on_fixed, &n = first->contact.normal;
  return {{"travel", first->travel},
          {"pose", {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()}},
          {"point", {at.x(), at.y(), at.z()}},
          {"normal", {n.x(), n.y(), n.z()}},
          {"tolerance", first->tolerance},
          {"part", part_of_fixed(fixed, at)}};
}

Json room_of(const LeastRoom& room) {
  return {{"clearance", room.clearance},
          {"travel", room.travel},
          {"tolerance", room.tolerance},
          {"searched", room.searched},
          {"complete", room.complete}};
}

/// Of a part that was written before the least clearance was searched for: that of its rows.
Json room_of_rows(const Json& rows) {
  Json out{{"clearance", nullptr},
           {"travel", nullptr},
           {"tolerance", nullptr},
           {"searched", 0.0},
           {"complete", false}};
  for (const Json& row : rows) {
    const Json &travel = row.at(0), &clearance = row.at(8);
    if (clearance.is_null()) continue;
    if (!out["clearance"].is_null() && !(clearance < out["clearance"])) continue;
    out["clearance"] = clearance;
    out["travel"] = travel;
  }
  return out;
}

std::string way_part(const InsertionRequest& request, const Progress& progress) {
  const Insertion found =
      insertion(request.pair, request.way, request.steps, request.coupling, progress);
  const Body& fixed = request.pair.fixed();
  Json out{{"steps", Json::array()},
           {"first", first_of(found.first, fixed)},
           {"room", room_of(found.room)}};
  for (const InsertionStep& step : found.steps)
    out["steps"].push_back(row_of(step, found.first, fixed));
  return out.dump();
}

/// A part's progress: said of the part, and asking whether to stop.
Progress told(const std::shared_ptr<std::atomic<double>>& done, const Stop& stop) {
  return [done, stop](double fraction) {
    *done = fraction;
    return !(stop && stop());
  };
}

std::string map_row(const InsertionRequest& request, std::size_t i, const Progress& progress) {
  const InsertionMap& map = *request.map;
  const double offset = map.offset(i);
  Json row{{"offset", offset}, {"travel", Json::array()}};
  for (std::size_t j = 0; j < map.tilts; ++j) {
    const InsertionPath way = moved(request.way, request.pair, map, offset, map.tilt(j));
    const double all = static_cast<double>(map.tilts), at = static_cast<double>(j);
    row["travel"].push_back(
        free_travel(request.pair, way, part_of(progress, at / all, (at + 1) / all)));
  }
  return row.dump();
}

/// The results of the parts: the path, and the rows of the map.
struct InsertionParts {
  Json way;
  std::vector<Json> map;
};
InsertionParts parts_in(const std::string& folder, const StudyFolder& study) {
  InsertionParts out;
  for (std::size_t i = 0; i < study.names.size(); ++i) {
    if (!study.results[i])
      throw InputError::in(folder, "the part " + study.names[i] + " is missing");
    try {
      Json part = Json::parse(*study.results[i]);
      if (study.names[i] == "way") {
        part.at("steps").get<std::vector<Json>>();
        part.at("first");
        if (!part.contains("room")) part["room"] = room_of_rows(part.at("steps"));
        part.at("room").at("clearance");
        out.way = std::move(part);
      } else {
        part.at("offset").get<double>();
        part.at("travel").get<std::vector<double>>();
        out.map.push_back(std::move(part));
      }
    } catch (const Json::exception&) {
      throw InputError::in(folder, "the part " + study.names[i] + " was not written by a study");
    }
  }
  if (out.way.is_null()) throw InputError::in(folder, "the part way is missing");
  return out;
}

std::string csv_number(const Json& value) {
  return value.is_null() ? "" : number_text(value.get<double>(), 17);
}
std::string csv_cell(const Json& value) {
  return value.is_string() ? csv_word(value.get<std::string>()) : csv_number(value);
}

std::string way_table(const Json& way) {
  std::string out = std::string(columns) + "\n";
  for (const Json& row : way.at("steps")) {
    const char* separator = "";
    for (const Json& cell : row) {
      out.append(separator).append(csv_cell(cell));
      separator = ",";
    }
    // A part that was written before a column was added.
    for (std::size_t i = row.size(); i < count_of_columns; ++i) out += ",";
    out += "\n";
  }
  return out;
}

std::string way_picture(const Json& way) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> travel, clearance, depth, force;
  for (const Json& row : way.at("steps")) {
    const auto number = [&](std::size_t i) {
      return row[i].is_null() ? none : row[i].get<double>();
    };
    travel.push_back(to_mm * number(0));
    clearance.push_back(to_mm * number(8));
    depth.push_back(to_mm * number(9));
    force.push_back(Vec3(number(10), number(11), number(12)).norm());
  }
  SvgChart chart{"Along the way", {}};
  const ChartAxis x{"travel, mm"};
  ChartPanel room{"Room, and how far the probe is held back", x, {"room, depth, mm"}, {}, {}, {}};
  room.series = {{"clearance", travel, clearance}, {"depth held", travel, depth}};
  ChartPanel felt{"Force on the hand", x, {"force, N"}, {}, {}, {}};
  felt.series = {{"force", travel, force}};
  if (const Json& first = way.at("first"); !first.is_null()) {
    const double at = to_mm * first.at("travel").get<double>();
    double most = 0;
    for (const double y : force) most = std::max(most, y);
    felt.series.push_back({"first contact", {at, at}, {0, most}, ChartSeries::Form::dashed});
  }
  chart.panels = {room, felt};
  return to_svg(chart);
}

std::string map_table(const std::vector<Json>& map, const Json& about) {
  std::string out = "offset,tilt,free_travel,goes_in\n";
  const double largest = about.at("largest_tilt").get<double>(),
               wanted = about.at("wanted").get<double>();
  for (const Json& row : map) {
    const auto travels = row.at("travel").get<std::vector<double>>();
    const InsertionMap tilts{.largest_tilt = largest, .tilts = travels.size()};
    for (std::size_t j = 0; j < travels.size(); ++j)
      out += csv_number(row.at("offset")) + "," + number_text(tilts.tilt(j), 17) + "," +
             (travels[j] < 0 ? "" : number_text(travels[j], 17)) + "," +
             (travels[j] >= wanted ? "1" : "0") + "\n";
  }
  return out;
}

std::string map_picture(const std::vector<Json>& map, const Json& about) {
  const double tilt = to_degrees * about.at("largest_tilt").get<double>(),
               offset = to_mm * about.at("largest_offset").get<double>(),
               wanted = about.at("wanted").get<double>();
  ChartPanel panel{"Offsets and tilts at the mouth that go in",
                   {"offset, mm"},
                   {"tilt, degrees"},
                   {},
                   {},
                   {},
                   380};
  panel.kinds = {{"goes in", "#1b7837"},
                 {"binds on the way", "#fdae61"},
                 {"overlaps where it begins", "#bababa"}};
  // Each value is the middle of its cell; a single value has a cell about 0.
  const auto edge = [](std::size_t i, std::size_t count, double largest) {
    if (count < 2) return i == 0 ? -1.0 : 1.0;
    return largest * ((2 * static_cast<double>(i) - 1) / static_cast<double>(count - 1) - 1);
  };
  for (std::size_t i = 0; i < map.size(); ++i) {
    const auto travels = map[i].at("travel").get<std::vector<double>>();
    for (std::size_t j = 0; j < travels.size(); ++j)
      panel.cells.push_back({edge(i, map.size(), offset), edge(i + 1, map.size(), offset),
                             edge(j, travels.size(), tilt), edge(j + 1, travels.size(), tilt),
                             travels[j] >= wanted ? 0u
                             : travels[j] >= 0    ? 1u
                                                  : 2u});
  }
  return to_svg(SvgChart{"How it may be off and still go in", {panel}});
}

/// The most important numbers.
Json summary_of(const InsertionParts& parts, const Json& about) {
  double deepest = 0, largest = 0;
  for (const Json& row : parts.way.at("steps")) {
    if (!row[9].is_null()) deepest = std::max(deepest, row[9].get<double>());
    largest = std::max(
        largest, Vec3(row[10].get<double>(), row[11].get<double>(), row[12].get<double>()).norm());
  }
  const Json& room = parts.way.at("room");
  Json out{{"format", 1},
           {"travel", parts.way.at("steps").back()[0]},
           {"first_contact", parts.way.at("first")},
           {"goes_in",
            parts.way.at("first").is_null() || parts.way.at("first").at("travel").get<double>() >=
                                                   about.at("wanted").get<double>()},
           {"least_clearance", room.at("clearance")},
           {"largest_depth", deepest},
           {"largest_force", largest},
           {"least_clearance_at", room.at("travel")},
           {"least_clearance_tolerance", room.at("tolerance")},
           {"least_clearance_searched", room.at("searched")},
           {"least_clearance_complete", room.at("complete")}};
  if (!parts.map.empty()) {
    std::size_t in = 0, all = 0;
    for (const Json& row : parts.map)
      for (const double travel : row.at("travel").get<std::vector<double>>())
        in += travel >= about.at("wanted").get<double>(), ++all;
    out["map"] = {{"goes_in", in}, {"all", all}};
  }
  out["about"] = about;
  return out;
}

/// What the faces of the probe were moved by; empty if by nothing.
std::string offset_words_for(const Json& about) {
  const double by = about.value(Json::json_pointer("/inputs/probe/offset"), 0.0);
  if (by == 0) return {};
  return "The probe is taken " + number_text(to_mm * std::abs(by), 6) + " mm " +
         (by < 0 ? "smaller (allowance)" : "larger (safety)") + ".\n";
}

/// ", on NAME": the part that binds; empty if the fixed body is of one mesh.
std::string on_part(const Json& first) {
  const auto part = first.find("part");
  if (part == first.end() || !part->is_string()) return {};
  return ", on " + printable(part->get<std::string>());
}

/// Of a way that goes in: one that binds has none where it does, which says nothing.
std::string room_words_for(const Json& summary) {
  const auto mm = [](const Json& x) { return number_text(to_mm * x.get<double>(), 6) + " mm"; };
  std::string out;
  if (!summary.at("least_clearance").is_null())
    out += "The least room where it is free is " + mm(summary.at("least_clearance")) + ", at " +
           mm(summary.at("least_clearance_at")) + ".\n";
  if (!summary.at("least_clearance_complete").get<bool>())
    out += "The search for it ended at its limit of work after " +
           mm(summary.at("least_clearance_searched")) +
           ": of what is beyond, the rows of the table count and no place between them.\n";
  return out;
}

std::string words_for(const Json& summary) {
  const auto mm = [](const Json& x) { return number_text(to_mm * x.get<double>(), 6) + " mm"; };
  std::string out = "# Insertion\n\n";
  const Json& first = summary.at("first_contact");
  if (first.is_null()) {
    out += "It goes in: all of the " + mm(summary.at("travel")) + " are free.\n";
    out += room_words_for(summary);
  } else {
    const Json& at = first.at("point");
    out += "It binds after " + mm(first.at("travel")) + " of " + mm(summary.at("travel")) +
           on_part(first) + ", at (" + mm(at[0]) + ", " + mm(at[1]) + ", " + mm(at[2]) + ").\n";
    out += "Pushed on to the end it is held back by " + mm(summary.at("largest_depth")) +
           " at most, with " + number_text(summary.at("largest_force").get<double>(), 4) +
           " N at the scene's gains.\n";
  }
  if (summary.contains("map"))
    out += summary.at("map").at("goes_in").dump() + " of " + summary.at("map").at("all").dump() +
           " offsets and tilts go in (map.svg).\n";
  out += offset_words_for(summary.at("about"));
  return out;
}

}  // namespace

Study plan_insertion(const InsertionRequest& request) {
  Study study{kind_of_study, request.about, {}};
  const auto add = [&study](const std::string& name, auto compute) {
    const auto done = std::make_shared<std::atomic<double>>(0);
    study.parts.push_back(
        {name, [=](const Stop& stop) { return compute(told(done, stop)); }, done});
  };
  add("way", [request](const Progress& progress) { return way_part(request, progress); });
  const std::size_t rows = request.map ? request.map->offsets : 0;
  for (std::size_t i = 0; i < rows; ++i)
    add("offset-" + std::to_string(i),
        [request, i](const Progress& progress) { return map_row(request, i, progress); });
  return study;
}

std::vector<StudyFile> insertion_files(const std::string& folder, const StudyFolder& study) {
  const InsertionParts parts = parts_in(folder, study);
  const Json about = Json::parse(study.about);
  const Json summary = summary_of(parts, about);
  std::vector<StudyFile> files{{"insert.csv", way_table(parts.way)},
                               {"insert.svg", way_picture(parts.way)}};
  if (!parts.map.empty()) {
    files.push_back({"map.csv", map_table(parts.map, about)});
    files.push_back({"map.svg", map_picture(parts.map, about)});
  }
  files.push_back({"summary.json", summary.dump(1) + "\n"});
  files.push_back({"summary.md", words_for(summary)});
  return files;
}

}  // namespace sonde
