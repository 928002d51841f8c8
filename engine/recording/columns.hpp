// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sonde {

/// The number type of a column in a file, little-endian.
enum class Stored { f64, f32, u64, u32, u8 };
const char* name_of(Stored as);
std::size_t width(Stored as) noexcept;  ///< bytes

/// The stored bits of a number, and the number of these bits. Integers are exact up to 2^53.
std::uint64_t bits_of(double value, Stored as) noexcept;
double value_of(std::uint64_t bits, Stored as) noexcept;

/// A number as the value of a field. A file may contain any number: one beyond an integer's range
/// becomes the nearest in it, and NaN becomes zero.
template <class Field>
Field field_of(double value) noexcept {
  if constexpr (std::is_same_v<Field, bool>) {
    return value != 0;
  } else if constexpr (std::is_integral_v<Field>) {
    constexpr Field least = std::numeric_limits<Field>::min();
    constexpr Field most = std::numeric_limits<Field>::max();
    if (std::isnan(value)) return 0;
    if (value <= static_cast<double>(least)) return least;
    return value >= static_cast<double>(most) ? most : static_cast<Field>(value);
  } else {
    return static_cast<Field>(value);
  }
}

/// One quantity of a row, with its getter and setter.
template <class Row>
struct Column {
  const char* name;
  const char* unit;  ///< SI, "" if there is none
  Stored as;
  double (*get)(const Row& row);
  void (*set)(Row& row, double value);
};

/// Numbers of one width, each combined (XOR) with the previous one, in planes of bytes: the lowest
/// byte of each first, the highest last. Slow changes become runs of zeros.
void append_planes(std::string& out, std::span<const std::uint64_t> bits, std::size_t width);
/// Reads them from the front of the text and removes them. Throws std::invalid_argument if the text
/// is too short.
std::vector<std::uint64_t> take_planes(std::string_view& in, std::size_t count, std::size_t width);

void append_count(std::string& out, std::uint32_t count);
std::uint32_t take_count(std::string_view& in);  ///< throws std::invalid_argument

/// The number of rows, then column after column.
template <class Row>
void append_table(std::string& out, std::span<const Row> rows,
                  std::span<const Column<Row>> columns) {
  append_count(out, static_cast<std::uint32_t>(rows.size()));
  std::vector<std::uint64_t> bits(rows.size());
  for (const Column<Row>& column : columns) {
    for (std::size_t i = 0; i < rows.size(); ++i) bits[i] = bits_of(column.get(rows[i]), column.as);
    append_planes(out, bits, width(column.as));
  }
}

/// Reads a table from the front and removes it. Throws std::invalid_argument if the text is too
/// short.
template <class Row>
std::vector<Row> take_table(std::string_view& in, std::span<const Column<Row>> columns) {
  const std::size_t count = take_count(in);
  std::vector<Row> rows;
  for (const Column<Row>& column : columns) {
    const std::vector<std::uint64_t> bits = take_planes(in, count, width(column.as));
    rows.resize(count);  // only now: the text has proved to hold this many rows
    for (std::size_t i = 0; i < count; ++i) column.set(rows[i], value_of(bits[i], column.as));
  }
  return rows;
}

}  // namespace sonde
