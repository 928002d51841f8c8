// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/csv_rows.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

/// Iterates over the lines of a text, without their ends (LF or CRLF).
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {}
  std::size_t number() const { return number_; }
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    ++number_;
    return true;
  }
  /// True if only blank lines are left.
  bool only_blank_left() const {
    return rest_.find_first_not_of(" \t\r\n") == std::string_view::npos;
  }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

double number_in(std::string_view field, std::string_view name) {
  const auto value = parse_number(field);
  if (!value || !std::isfinite(*value))
    throw std::invalid_argument(std::string(name) + " is " + in_quotes(field) +
                                ", which is not a finite number");
  return *value;
}

/// The numbers of one line, one for each of `columns`.
std::vector<double> numbers_in(std::string_view line, std::span<const std::string_view> columns) {
  std::vector<double> numbers(columns.size());
  std::size_t n = 0;
  for (;;) {
    const std::size_t comma = line.find(',');
    if (n < columns.size()) numbers[n] = number_in(line.substr(0, comma), columns[n]);
    ++n;
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  if (n != columns.size())
    throw std::invalid_argument(std::to_string(n) + " columns; expected " +
                                std::to_string(columns.size()));
  return numbers;
}

std::string header_of(std::span<const std::string_view> columns) {
  std::string header;
  for (const std::string_view name : columns) header.append(header.empty() ? "" : ",").append(name);
  return header;
}

}  // namespace

void read_csv_rows(const std::filesystem::path& file, std::span<const std::string_view> columns,
                   std::size_t most_bytes,
                   const std::function<void(std::span<const double>)>& take) {
  read_csv_rows(file, columns, columns, most_bytes, take);
}

bool read_csv_rows(const std::filesystem::path& file, std::span<const std::string_view> first,
                   std::span<const std::string_view> second, std::size_t most_bytes,
                   const std::function<void(std::span<const double>)>& take) {
  const std::string text = read_text(file, most_bytes);
  refuse_utf16(file, text);
  Lines lines(text);
  std::string_view line;
  const std::string header = header_of(first), other = header_of(second);
  lines.next(line);
  if (line != header && line != other)
    throw InputError::at_line(file.string(), 1,
                              "the header is " + in_quotes(line) + "; expected \"" + header + "\"" +
                                  (other == header ? "" : " or \"" + other + "\""));
  const bool is_second = line != header;
  const std::span<const std::string_view> columns = is_second ? second : first;
  while (!lines.only_blank_left() && lines.next(line)) {
    try {
      if (line.empty()) throw std::invalid_argument("a blank line between rows");
      take(numbers_in(line, columns));
    } catch (const std::invalid_argument& error) {
      throw InputError::at_line(file.string(), lines.number(), error.what());
    }
  }
  return is_second;
}

void expect_later(double t, double before) {
  if (t > before) return;
  throw std::invalid_argument("t = " + number_text(t) + " does not come after " +
                              number_text(before) + ": t must rise from row to row");
}

}  // namespace sonde
