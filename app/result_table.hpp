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

/// A value of a row: nothing, a number, a count, or a word.
using Cell = std::variant<std::monostate, double, std::int64_t, const char*>;
using Row = std::vector<Cell>;

/// The result of a command, to be written whole.
struct ResultTable {
  std::span<const Column> columns;
  std::vector<Row> rows;
  double probe_offset = 0;  ///< m, by which the probe is taken larger, less than zero smaller
  std::vector<std::string> remarks =
      {};  ///< on the bodies; in the head of JSON, where there are any
};

void append(Row& row, const Vec3& v);
void append(Row& row, const Pose& pose);  ///< px, py, pz, qw, qx, qy, qz
void append_nothing(Row& row, int count);

/// A header and one line for each row; numbers with 17 significant digits.
std::string to_csv(const ResultTable& table);
/// {"units": {column: unit, ...}, "results": [{column: value, ...}, ...]}; nothing becomes null. An
/// offset of the probe stands between the two, "probe_offset", in m, and "remarks" on the bodies.
std::string to_json(const ResultTable& table);

}  // namespace sonde::app
