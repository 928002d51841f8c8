// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sonde::bench {

struct Column {
  std::string name;
  std::string unit;  ///< "" where there is none
};

/// Nothing, a number, a count or a text.
using Cell = std::variant<std::monostate, double, std::int64_t, std::string>;

/// The number, or nothing.
inline Cell cell(std::optional<double> value) {
  if (!value) return std::monostate{};
  return *value;
}

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

/// For reading: columns aligned, numbers with three significant digits, a dash where there is
/// nothing.
std::string to_text(const Table& table);
/// A header and one line for each row (RFC 4180), numbers with 17 significant digits.
std::string to_csv(const Table& table);
/// {"units": {column: unit, ...}, "rows": [{column: value, ...}, ...]}; nothing becomes null.
std::string to_json(const Table& table);

}  // namespace sonde::bench
