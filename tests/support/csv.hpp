// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace sonde::test {

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text)
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// A CSV result: its header and its fields.
struct Csv {
  std::string header;
  std::vector<std::vector<std::string>> rows;

  explicit Csv(const std::string& text) {
    std::vector<std::string> lines = split(text, '\n');
    lines.pop_back();  // after the last line's end
    if (lines.empty()) return;
    header = lines[0];
    for (std::size_t i = 1; i < lines.size(); ++i) rows.push_back(split(lines[i], ','));
  }
  std::size_t column(const std::string& name) const {
    const auto names = split(header, ',');
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i] == name) return i;
    throw std::out_of_range("no column " + name);
  }
  const std::string& text(std::size_t row, const std::string& name) const {
    return rows.at(row).at(column(name));
  }
  double number(std::size_t row, const std::string& name) const {
    return std::stod(text(row, name));
  }
  /// Without the columns that tell times, and so differ from run to run.
  std::vector<std::vector<std::string>> without(const std::vector<std::string>& names) const {
    auto copy = rows;
    for (auto& row : copy)
      for (const auto& name : names) row.at(column(name)).clear();
    return copy;
  }
};

}  // namespace sonde::test
