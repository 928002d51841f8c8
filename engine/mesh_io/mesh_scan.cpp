// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/mesh_scan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

namespace sonde {
namespace {

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

/// A word as a number: infinite where it is too large, 0 where it is too small for a double; none
/// where it is no number.
std::optional<double> number(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range)
    return word.find("e-") != word.npos || word.find("E-") != word.npos
               ? 0
               : std::numeric_limits<double>::infinity();
  if (error != std::errc()) return {};
  return value;
}

}  // namespace

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string out(word.substr(0, longest));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return "\"" + out + (word.size() > longest ? "...\"" : "\"");
}

MeshScanner::MeshScanner(const std::string& file, std::string_view text, char comment,
                         bool continues, const Progress& progress)
    : file_(file), text_(text), comment_(comment), continues_(continues), progress_(progress) {}

bool MeshScanner::is_blank(char c) const {
  return c == ' ' || (c >= '\t' && c <= '\r') || (c == '\\' && continues_);
}

void MeshScanner::report() const {
  if (progress_ && !progress_(static_cast<double>(next_) /
                              static_cast<double>(std::max<std::size_t>(1, text_.size()))))
    throw Cancelled();
}

void MeshScanner::find_line_end() {
  line_ = next_number_;
  at_ = next_;
  for (;;) {
    const std::size_t newline = text_.find('\n', next_);
    end_ = newline == text_.npos ? text_.size() : newline;
    next_ = newline == text_.npos ? text_.size() : newline + 1;
    ++next_number_;
    std::size_t last = end_;
    while (last > at_ && text_[last - 1] == '\r') --last;
    const bool joined = continues_ && newline != text_.npos && last > at_ &&
                        text_[last - 1] == '\\' && text_[at_] != comment_;
    if (!joined) break;
  }
  if (comment_ != '\0') {
    const std::string_view line = text_.substr(at_, end_ - at_);
    end_ = at_ + std::min(line.find(comment_), line.size());
  }
}

bool MeshScanner::next_line() {
  while (next_ < text_.size()) {
    if ((++lines_seen_ & 0x3fff) == 0) report();
    find_line_end();
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
    if (at_ < end_) return true;
  }
  return false;
}

std::string_view MeshScanner::word() {
  while (at_ < end_ && is_blank(text_[at_])) ++at_;
  const std::size_t start = at_;
  while (at_ < end_ && !is_blank(text_[at_])) ++at_;
  return text_.substr(start, at_ - start);
}

std::size_t MeshScanner::skip_words() {
  std::size_t n = 0;
  while (!word().empty()) ++n;
  return n;
}

double MeshScanner::coordinate() {
  const std::string_view w = word();
  if (w.empty()) refuse("three coordinates expected");
  const std::optional<double> value = number(w);
  if (!value) refuse(shown(w) + " is not a number");
  if (!std::isfinite(*value)) refuse("the coordinate " + shown(w) + " is not finite");
  return *value;
}

void MeshScanner::check_number() {
  const std::string_view w = word();
  if (w.empty()) refuse("the line ends too early");
  if (!number(w)) refuse(shown(w) + " is not a number");
}

std::int64_t MeshScanner::integer(std::string_view word, const char* what) const {
  const std::string_view w = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
  if (error != std::errc() || end != w.data() + w.size())
    refuse(word.empty() ? std::string("the line ends where ") + what + " is expected"
                        : shown(word) + " is not " + what);
  return value;
}

std::uint64_t MeshScanner::count(const char* what) {
  const std::string_view w = word();
  const std::int64_t value = integer(w, what);
  if (value < 0) refuse(shown(w) + " is not " + what);
  return static_cast<std::uint64_t>(value);
}

std::uint64_t MeshScanner::index(std::uint64_t vertices) {
  const std::string_view w = word();
  const std::int64_t value = integer(w, "a vertex index");
  if (value < 0 || static_cast<std::uint64_t>(value) >= vertices)
    refuse("vertex index " + std::to_string(value) + " is out of range (0 to " +
           std::to_string(vertices - 1) + ")");
  return static_cast<std::uint64_t>(value);
}

void MeshScanner::refuse(const std::string& reason) const { refuse_at(line_, reason); }

void MeshScanner::refuse_at(std::size_t line, const std::string& reason) const {
  throw InputError::at_line(file_, std::max<std::size_t>(1, line), reason);
}

}  // namespace sonde
