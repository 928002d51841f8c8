// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/result_table.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/text/csv_word.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

constexpr int digits = 17;  // enough to read back the same double

struct ToText {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(double value) const { return number_text(value, digits); }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(bool value) const { return value ? "1" : "0"; }
  std::string operator()(const char* value) const { return csv_word(value); }
};

struct ToJson {
  nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
  nlohmann::ordered_json operator()(const char* value) const { return utf8_text(value); }
  nlohmann::ordered_json operator()(auto value) const { return value; }
};

nlohmann::ordered_json object_of(std::span<const Column> columns, std::span<const Cell> cells) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < std::min(columns.size(), cells.size()); ++i)
    object[columns[i].name] = std::visit(ToJson{}, cells[i]);
  return object;
}

}  // namespace

void append(Row& row, const Vec3& v) { row.insert(row.end(), {v.x(), v.y(), v.z()}); }

void append(Row& row, const Pose& pose) {
  append(row, pose.p);
  row.insert(row.end(), {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()});
}

void append_nothing(Row& row, int count) {
  row.insert(row.end(), static_cast<std::size_t>(count), std::monostate{});
}

std::string csv_line(const Row& row) {
  std::string line;
  const char* separator = "";
  for (const Cell& cell : row) {
    line.append(separator).append(std::visit(ToText{}, cell));
    separator = ",";
  }
  return line;
}

std::string json_line(std::span<const Column> columns, const Row& row) {
  return object_of(columns, row).dump();
}

std::string json_line(std::span<const Column> columns, const Row& row, const InnerRows& inner) {
  nlohmann::ordered_json object = object_of(columns, row), rows = nlohmann::ordered_json::array();
  for (const Row& each : inner.rows)
    rows.push_back(object_of(inner.columns, std::span(each).subspan(inner.skipped)));
  object[inner.name] = std::move(rows);
  return object.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string csv_of(const ResultHead& head, std::span<const std::string> lines) {
  std::string text;
  const char* separator = "";
  for (const Column& column : head.columns) {
    text.append(separator).append(column.name);
    separator = ",";
  }
  text += '\n';
  for (const std::string& line : lines) text.append(line).append("\n");
  return text;
}

std::string json_of(const ResultHead& head, std::span<const std::string> lines) {
  nlohmann::ordered_json units = nlohmann::ordered_json::object();
  for (const Column& column : head.columns)
    if (*column.unit != 0) units[column.name] = column.unit;
  if (head.probe_offset != 0) units["probe_offset"] = "m";
  // Row by row: one line each, and never the whole table as a tree in memory.
  std::string text = "{\"format\": 1,\n\"units\": " + units.dump() + ",\n";
  if (head.probe_offset != 0)
    text += "\"probe_offset\": " + nlohmann::json(head.probe_offset).dump() + ",\n";
  if (!head.remarks.empty()) {
    nlohmann::ordered_json remarks;
    for (const std::string& remark : head.remarks) remarks.push_back(utf8_text(remark));
    text += "\"remarks\": " + remarks.dump() + ",\n";
  }
  text += "\"results\": [";
  const char* separator = "\n";
  for (const std::string& line : lines) {
    text.append(separator).append(line);
    separator = ",\n";
  }
  return text + "\n]}\n";
}

std::string to_csv(const ResultTable& table) {
  std::vector<std::string> lines;
  for (const Row& row : table.rows) lines.push_back(csv_line(row));
  return csv_of(table.head, lines);
}

std::string to_json(const ResultTable& table) {
  std::vector<std::string> lines;
  for (const Row& row : table.rows) lines.push_back(json_line(table.head.columns, row));
  return json_of(table.head, lines);
}

}  // namespace sonde::app
