// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/geometry/pose.hpp"

namespace sonde::app {

struct Column {
  const char* name;
  const char* unit;  ///< "" where there is none
};

/// A value of a row: nothing, a number, a count, yes or no, or a word. (In CSV, yes is 1.)
using Cell = std::variant<std::monostate, double, std::int64_t, bool, const char*>;
using Row = std::vector<Cell>;

/// What stands before the rows of a result.
struct ResultHead {
  std::span<const Column> columns;
  double probe_offset = 0;  ///< m, by which the probe is taken larger, less than zero smaller
  std::vector<std::string> remarks =
      {};  ///< on the bodies; in the head of JSON, where there are any
};
/// The result of a command, to be written whole.
struct ResultTable {
  ResultHead head;
  std::vector<Row> rows;
};

void append(Row& row, const Vec3& v);
void append(Row& row, const Pose& pose);  ///< px, py, pz, qw, qx, qy, qz
void append_nothing(Row& row, int count);

/// One row as a line of its own, without its end; numbers with 17 significant digits.
std::string csv_line(const Row& row);
std::string json_line(std::span<const Column> columns, const Row& row);
/// Rows within a row: in JSON alone.
struct InnerRows {
  const char* name;
  std::span<const Column> columns;
  std::span<const Row> rows;
  std::size_t skipped = 0;  ///< cells at the beginning of each row that are left out
};
std::string json_line(std::span<const Column> columns, const Row& row, const InnerRows& inner);
/// The result of such lines. CSV: a header and the lines. JSON: {"format": 1, "units": {column:
/// unit, ...}, "results": [{column: value, ...}, ...]}; nothing becomes null. An offset of the
/// probe stands before the results, "probe_offset", in m, and "remarks" on the bodies.
std::string csv_of(const ResultHead& head, std::span<const std::string> lines);
std::string json_of(const ResultHead& head, std::span<const std::string> lines);
std::string to_csv(const ResultTable& table);
std::string to_json(const ResultTable& table);

}  // namespace sonde::app
