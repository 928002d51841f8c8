// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_series.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 26;
constexpr const char* header = "series,pose,depth,time_us";

std::array<std::string, 4> fields_of(const std::string& line) {
  std::array<std::string, 4> out;
  std::size_t n = 0, from = 0;
  for (;;) {
    const std::size_t comma = line.find(',', from);
    if (n < out.size()) out[n] = line.substr(from, comma - from);
    ++n;
    if (comma == std::string::npos) break;
    from = comma + 1;
  }
  if (n != out.size())
    throw std::invalid_argument(std::to_string(n) + " columns; expected " + header);
  return out;
}

double number_in(const std::string& field, const char* name) {
  const auto value = parse_number(field);
  if (!value || !std::isfinite(*value) || *value < 0)
    throw std::invalid_argument(std::string(name) + " is " + in_quotes(field) +
                                ", which is not a number of 0 or more");
  return *value;
}

TradeAnswer answer_in(const std::string& line, std::size_t poses) {
  const auto [series, pose, depth, time_us] = fields_of(line);
  if (series.empty()) throw std::invalid_argument("the series has no name");
  const double index = number_in(pose, "pose");
  if (index != std::floor(index) || index >= double(poses))
    throw std::invalid_argument("pose " + pose.substr(0, 60) + " is none of the study, which has " +
                                std::to_string(poses));
  return {series, static_cast<std::size_t>(index),
          depth.empty() ? infinity : number_in(depth, "depth"), number_in(time_us, "time_us")};
}

void add(std::vector<TradeSeries>& all, const TradeAnswer& answer, const TradeResults& results) {
  const double reference = results.poses[answer.pose].reference(Method::pdg);
  if (!is_deep_enough(results, results.poses[answer.pose])) return;
  auto at = std::ranges::find(all, answer.series, &TradeSeries::name);
  if (at == all.end()) at = all.insert(at, {answer.series, {}, {}});
  at->errors.push_back(std::abs(answer.depth / reference - 1));
  at->times.push_back(answer.time_us);
}

}  // namespace

std::vector<TradeAnswer> read_trade_answers(const std::filesystem::path& file, std::size_t poses) {
  std::istringstream text(read_text(file, most_bytes));
  std::vector<TradeAnswer> out;
  std::string line;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    try {
      if (number == 1 && line != header)
        throw std::invalid_argument(std::string("the header must be ") + header);
      if (number > 1 && !line.empty()) out.push_back(answer_in(line, poses));
    } catch (const std::invalid_argument& bad) {
      throw InputError::at_line(file.string(), number, bad.what());
    }
  }
  return out;
}

std::vector<TradeSeries> trade_series(const std::vector<TradeAnswer>& answers,
                                      const TradeResults& results) {
  std::vector<TradeSeries> all;
  for (const TradeAnswer& answer : answers) add(all, answer, results);
  for (TradeSeries& series : all) {
    ordering::sort(series.errors);
    ordering::sort(series.times);
  }
  return all;
}

}  // namespace sonde
