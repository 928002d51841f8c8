// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/result_table.hpp"

#include <nlohmann/json.hpp>

#include "engine/text/number_text.hpp"

namespace sonde::app {
namespace {

constexpr int digits = 17;  // enough to read back the same double

struct ToText {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(double value) const { return number_text(value, digits); }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(const char* value) const { return value; }
};

struct ToJson {
  nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
  nlohmann::ordered_json operator()(auto value) const { return value; }
};

}  // namespace

void append(Row& row, const Vec3& v) { row.insert(row.end(), {v.x(), v.y(), v.z()}); }

void append(Row& row, const Pose& pose) {
  append(row, pose.p);
  row.insert(row.end(), {pose.q.w(), pose.q.x(), pose.q.y(), pose.q.z()});
}

void append_nothing(Row& row, int count) {
  row.insert(row.end(), static_cast<std::size_t>(count), std::monostate{});
}

std::string to_csv(const ResultTable& table) {
  std::string text;
  const char* separator = "";
  for (const Column& column : table.columns) {
    text.append(separator).append(column.name);
    separator = ",";
  }
  text += '\n';
  for (const Row& row : table.rows) {
    separator = "";
    for (const Cell& cell : row) {
      text.append(separator).append(std::visit(ToText{}, cell));
      separator = ",";
    }
    text += '\n';
  }
  return text;
}

std::string to_json(const ResultTable& table) {
  nlohmann::ordered_json units = nlohmann::ordered_json::object();
  for (const Column& column : table.columns)
    if (*column.unit != 0) units[column.name] = column.unit;
  if (table.probe_offset != 0) units["probe_offset"] = "m";
  // Row by row: one line each, and never the whole table as a tree in memory.
  std::string text = "{\"units\": " + units.dump() + ",\n";
  if (table.probe_offset != 0)
    text += "\"probe_offset\": " + nlohmann::json(table.probe_offset).dump() + ",\n";
  if (!table.remarks.empty())
    text += "\"remarks\": " +
            nlohmann::ordered_json(table.remarks)
                .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
            ",\n";
  text += "\"results\": [";
  const char* separator = "\n";
  for (const Row& row : table.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i)
      object[table.columns[i].name] = std::visit(ToJson{}, row[i]);
    text.append(separator).append(object.dump());
    separator = ",\n";
  }
  return text + "\n]}\n";
}

}  // namespace sonde::app
