// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/text/number_text.hpp"

namespace sonde::bench {
namespace {

/// Three significant digits, never with an exponent.
std::string short_text(double value) {
  if (!std::isfinite(value)) return number_text(value);
  const double size = std::abs(value);
  const int decimals = size >= 99.95 ? 0 : size >= 9.995 ? 1 : size >= 0.9995 ? 2 : 3;
  std::array<char, 400> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals);
  return {text.data(), end.ptr};
}

struct ToText {
  std::string operator()(std::monostate) const { return "-"; }
  std::string operator()(double value) const { return short_text(value); }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(const std::string& value) const { return value; }
};

std::string quoted(const std::string& value) {
  if (value.find_first_of(",\"\r\n") == std::string::npos) return value;
  std::string out = "\"";
  for (const char c : value) out.append(c == '"' ? 2 : 1, c);
  return out + '"';
}

struct ToCsv {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(double value) const { return number_text(value, 17); }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(const std::string& value) const { return quoted(value); }
};

struct ToJson {
  nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
  nlohmann::ordered_json operator()(const auto& value) const { return value; }
};

/// Characters, not bytes, so that µ does not shift a column.
std::size_t characters_in(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t to, bool left) {
  const std::string blanks(to - std::min(to, characters_in(text)), ' ');
  return left ? text + blanks : blanks + text;
}

/// Text columns are flush left, numbers flush right.
bool holds_text(const Table& table, std::size_t column) {
  return std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
    return std::holds_alternative<std::string>(row[column]);
  });
}

}  // namespace

std::string to_text(const Table& table) {
  std::vector<std::vector<std::string>> lines(2);
  for (const Column& column : table.columns) {
    lines[0].push_back(column.name);
    lines[1].push_back(column.unit);
  }
  for (const auto& row : table.rows) {
    auto& line = lines.emplace_back();
    for (const Cell& cell : row) line.push_back(std::visit(ToText{}, cell));
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      widths[i] = std::max(widths[i], characters_in(line[i]));
  std::string text;
  for (const auto& line : lines) {
    std::string out;
    for (std::size_t i = 0; i < line.size(); ++i)
      out += (i ? "  " : "") + padded(line[i], widths[i], holds_text(table, i));
    out.erase(out.find_last_not_of(' ') + 1);
    text += out + '\n';
  }
  return text;
}

std::string to_csv(const Table& table) {
  std::string text;
  const char* separator = "";
  for (const Column& column : table.columns) {
    text.append(separator).append(quoted(column.name));
    separator = ",";
  }
  text += '\n';
  for (const auto& row : table.rows) {
    separator = "";
    for (const Cell& cell : row) {
      text.append(separator).append(std::visit(ToCsv{}, cell));
      separator = ",";
    }
    text += '\n';
  }
  return text;
}

std::string to_json(const Table& table) {
  nlohmann::ordered_json out;
  out["units"] = nlohmann::ordered_json::object();
  for (const Column& column : table.columns)
    if (!column.unit.empty()) out["units"][column.name] = column.unit;
  out["rows"] = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i)
      object[table.columns[i].name] = std::visit(ToJson{}, row[i]);
    out["rows"].push_back(std::move(object));
  }
  return out.dump(1);
}

}  // namespace sonde::bench
