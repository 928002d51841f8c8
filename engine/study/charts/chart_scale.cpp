// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/charts/chart_scale.hpp"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

/// 1, 2 or 5 times a power of ten, so that about `count` steps make the length.
double round_step(double length, int count) {
  const double rough = length / count;
  const double decade = elementary::pow(10.0, std::floor(elementary::log10(rough)));
  for (const double mantissa : {1.0, 2.0, 5.0})
    if (mantissa * decade >= rough * (1 - 1e-9)) return mantissa * decade;
  return 10 * decade;
}

constexpr int linear_marks = 5;

/// Six digits hide the rounding of k × step; "1e-05" becomes "1e-5".
std::string tick_text(double value) {
  std::string text = number_text(value, 6);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  std::size_t digits = e + 1;
  if (text[digits] == '+') text.erase(digits, 1);
  if (text[digits] == '-') ++digits;
  while (text.size() > digits + 1 && text[digits] == '0') text.erase(digits, 1);
  return text;
}

bool drawable(double value, bool logarithmic) {
  return std::isfinite(value) && (!logarithmic || value > 0);
}

}  // namespace

ChartScale::ChartScale(const ChartAxis& axis, const std::vector<double>& values)
    : logarithmic_(axis.logarithmic) {
  hold(axis, values);
  give_length();
  round_ends();
  if (axis.from && drawable(*axis.from, logarithmic_)) low_ = raw(*axis.from);
  if (axis.to && drawable(*axis.to, logarithmic_)) high_ = raw(*axis.to);
  if (!(high_ > low_)) high_ = low_ + 1;
}

void ChartScale::hold(const ChartAxis& axis, std::vector<double> values) {
  for (const auto& end : {axis.from, axis.to})
    if (end) values.push_back(*end);
  std::erase_if(values, [&](double value) { return !drawable(value, logarithmic_); });
  if (values.empty()) return;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  low_ = raw(*least);
  high_ = raw(*most);
}

/// A range that rounding cannot divide is treated as a point and widened.
void ChartScale::give_length() {
  const double least = 1e-9 * std::max(std::abs(low_), std::abs(high_));
  if (high_ - low_ > (logarithmic_ ? 1e-9 : least)) return;
  const double about = logarithmic_ ? 0.5 : low_ == 0 ? 1 : 0.1 * std::abs(low_);
  low_ -= about;
  high_ += about;
}

void ChartScale::round_ends() {
  const double length = high_ - low_;
  if (logarithmic_ && length <= 1) {  // within a decade the ends are not round: leave a margin
    low_ -= 0.02;
    high_ += 0.02;
    return;
  }
  const double step = logarithmic_ ? 1 : round_step(length, linear_marks);
  low_ = step * std::floor(low_ / step + 1e-9);
  high_ = step * std::ceil(high_ / step - 1e-9);
}

double ChartScale::raw(double value) const {
  return logarithmic_ ? elementary::log10(value) : value;
}

std::optional<double> ChartScale::place(double value) const {
  if (!drawable(value, logarithmic_)) return std::nullopt;
  return (raw(value) - low_) / (high_ - low_);
}

std::vector<ChartScale::Tick> ChartScale::ticks() const {
  return logarithmic_ ? logarithmic_ticks() : linear_ticks();
}

std::vector<ChartScale::Tick> ChartScale::linear_ticks() const {
  std::vector<Tick> out;
  const double step = round_step(high_ - low_, linear_marks);
  for (double k = std::ceil(low_ / step - 1e-6); k * step <= high_ + 1e-6 * step; ++k)
    out.push_back({(k * step - low_) / (high_ - low_), tick_text(k * step + 0.0)});
  return out;
}

/// Every decade; if there are few decades, 2 and 5 also have numbers, and all digits have marks.
std::vector<ChartScale::Tick> ChartScale::logarithmic_ticks() const {
  std::vector<Tick> out;
  const double length = high_ - low_;
  const int stride = std::max(1, static_cast<int>(std::ceil(length / 10)));
  for (int decade = static_cast<int>(std::floor(low_)); decade <= std::ceil(high_);
       decade += stride)
    for (int digit = 1; digit < (length <= 5 ? 10 : 2); ++digit) {
      const double at = decade + elementary::log10(digit);
      if (at < low_ - 1e-9 || at > high_ + 1e-9) continue;
      const bool named = digit == 1 || (length <= 2.1 && (digit == 2 || digit == 5));
      out.push_back({(at - low_) / length,
                     named ? tick_text(digit * elementary::pow(10.0, decade)) : std::string()});
    }
  return out;
}

}  // namespace sonde
