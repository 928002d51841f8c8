// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/calibration/calibration_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/numbers.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

using Kind = JsonNode::Kind;

constexpr int format_version = 1;
constexpr std::size_t most_bytes = 1 << 26;
constexpr std::array<const char*, 2> answers_names{"search", "tick"};

/// Reads the values of one file; its errors name the file and the line.
struct Reader {
  const std::filesystem::path& file;

  const JsonNode& need(const JsonNode& object, std::string_view key, Kind kind) const {
    const JsonNode& node = need_key(file, object, key, "the calibration");
    expect_kind(file, node, kind);
    return node;
  }

  /// The index of a word among two.
  template <class Value>
  Value choice(const JsonNode& object, std::string_view key,
               const std::array<const char*, 2>& names) const {
    const JsonNode& node = need(object, key, Kind::string);
    const auto found = std::ranges::find(names, node.text);
    if (found == names.end())
      fail_at(file, node.line,
              in_quotes(key) + " is " + in_quotes(node.text) + "; expected " + in_quotes(names[0]) +
                  " or " + in_quotes(names[1]));
    return static_cast<Value>(found - names.begin());
  }

  double error(const JsonNode& node, double before) const {
    if (node.kind == Kind::null) return infinity;
    expect_kind(file, node, Kind::number);
    if (!(node.number >= before))
      fail_at(file, node.line,
              "an error of " + number_text(node.number) + " after " + number_text(before) +
                  "; they must not be negative, and ascend");
    return node.number;
  }

  CalibrationPoint point(const JsonNode& node) const {
    expect_keys(file, node, std::array<std::string_view, 3>{"time_us", "errors", "far_out"});
    CalibrationPoint out;
    const JsonNode& time = need(node, "time_us", Kind::number);
    out.time_us = time.number;
    if (!(out.time_us >= 0))
      fail_at(file, time.line,
              "\"time_us\" is " + number_text(out.time_us) + "; it must be 0 or more");
    out.errors = errors(need(node, "errors", Kind::array));
    if (node.find("far_out")) out.far_out = errors(need(node, "far_out", Kind::array));
    return out;
  }

  std::vector<double> errors(const JsonNode& node) const {
    std::vector<double> out;
    double before = 0;
    for (const JsonNode& each : node.children) out.push_back(before = error(each, before));
    return out;
  }

  CalibrationSeries series(const JsonNode& node) const {
    expect_keys(file, node,
                std::array<std::string_view, 6>{"pair", "family", "answers", "method", "sketched",
                                                "points"});
    CalibrationSeries out;
    out.pair = need(node, "pair", Kind::string).text;
    if (node.find("family")) out.family = need(node, "family", Kind::string).text;
    out.answers = choice<Answers>(node, "answers", answers_names);
    out.method = choice<Method>(node, "method", method_names);
    out.has_sketches = need(node, "sketched", Kind::boolean).boolean;
    for (const JsonNode& each : need(node, "points", Kind::array).children)
      out.points.push_back(point(each));
    return out;
  }

  void check_version(const JsonNode& root) const {
    const JsonNode& version = need(root, "calibration", Kind::number);
    if (version.number != format_version)
      fail_at(file, version.line,
              "a calibration of version " + number_text(version.number) +
                  "; this program reads version " + std::to_string(format_version) +
                  ": measure it anew (sonde calibrate)");
  }
};

}  // namespace

std::string to_json(const Calibration& calibration) {
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const CalibrationSeries& series : calibration.series) {
    Json points = Json::array();
    for (const CalibrationPoint& point : series.points) {  // infinite values become null
      points.push_back({{"time_us", point.time_us}, {"errors", point.errors}});
      if (point.far_out) points.back()["far_out"] = *point.far_out;
    }
    Json one{{"pair", series.pair}};
    if (!series.family.empty()) one["family"] = series.family;
    one["answers"] = answers_names[static_cast<std::size_t>(series.answers)];
    one["method"] = method_names[static_cast<std::size_t>(series.method)];
    one["sketched"] = series.has_sketches;
    one["points"] = std::move(points);
    all.push_back(std::move(one));
  }
  // One series per line: such files are read and compared by people.
  std::string out = "{\"calibration\": " + std::to_string(format_version) + ",\n \"series\": [";
  for (const Json& series : all)
    out += (&series == &all.front() ? "\n  " : ",\n  ") + series.dump();
  return out + "\n]}\n";
}

Calibration calibration_in(const std::string& text, const std::filesystem::path& file) {
  const Reader reader{file};
  const JsonNode root = parse_json(file.string(), text);
  expect_kind(file, root, Kind::object);
  reader.check_version(root);
  expect_keys(file, root, std::array<std::string_view, 2>{"calibration", "series"});
  Calibration out;
  for (const JsonNode& each : reader.need(root, "series", Kind::array).children)
    out.series.push_back(reader.series(each));
  if (out.series.empty()) fail_at(file, root.line, "a calibration of nothing: \"series\" is empty");
  return out;
}

Calibration read_calibration(const std::filesystem::path& file) {
  return calibration_in(read_text(file, most_bytes), file);
}

}  // namespace sonde
