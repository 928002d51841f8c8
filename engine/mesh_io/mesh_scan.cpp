// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/mesh_scan.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/mesh_io/plain_text.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde {
namespace {

std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

std::optional<double> number(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range) return out_of_range_number(word);
  if (error != std::errc()) return {};
  return value;
}

std::string shown(std::string_view word) {
  constexpr std::size_t longest = 40;
  return "\"" + typeable(word.substr(0, longest)) + (word.size() > longest ? "...\"" : "\"");
}

MeshScanner::MeshScanner(const std::string& file, std::string_view text, char comment,
                         bool continues, const Progress& progress)
    : file_(file),
      text_(text),
      comment_(comment),
      continues_(continues),
      progress_(progress),
      lf_(std::min(text.find('\n'), text.size())),
      cr_(std::min(text.find('\r'), text.size())) {}

bool MeshScanner::is_blank(char c) const {
  return c == ' ' || (c >= '\t' && c <= '\r') || (c == '\\' && continues_);
}

void MeshScanner::report() const {
  if (progress_ && !progress_(static_cast<double>(next_) /
                              static_cast<double>(std::max<std::size_t>(1, text_.size()))))
    throw Cancelled();
}

void MeshScanner::take_line_end() {
  if (lf_ < next_) lf_ = std::min(text_.find('\n', next_), text_.size());
  if (cr_ < next_) cr_ = std::min(text_.find('\r', next_), text_.size());
  const bool is_first = next_ == 0;
  if (lf_ < cr_) {
    end_ = lf_;
    next_ = lf_ + 1;
    return;
  }
  end_ = cr_;
  // Some programs that turn LF into CRLF do so twice: "\r\r\n".
  const std::size_t after = std::min(text_.find_first_not_of('\r', cr_), text_.size());
  const bool alone = after == text_.size() || text_[after] != '\n';
  next_ = std::min(alone ? cr_ + 1 : after + 1, text_.size());
  if (is_first) cr_alone_ = alone;
}

/// A backslash in a comment, the name of a file there for example, joins nothing.
bool MeshScanner::ends_in_backslash() const {
  std::size_t last = end_;
  while (last > at_ && text_[last - 1] != '\\' && is_blank(text_[last - 1])) --last;
  return last > at_ && text_[last - 1] == '\\' &&
         text_.substr(at_, last - at_).find(comment_) == text_.npos;
}

void MeshScanner::find_line_end() {
  line_ = next_number_;
  at_ = next_;
  for (;;) {
    take_line_end();
    ++next_number_;
    if (!continues_ || next_ == text_.size() || !ends_in_backslash()) break;
  }
  line_end_ = end_;
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

bool MeshScanner::has_word() {
  while (at_ < end_ && is_blank(text_[at_])) ++at_;
  return at_ < end_;
}

std::size_t MeshScanner::skip_words() {
  std::size_t n = 0;
  while (!word().empty()) ++n;
  return n;
}

std::optional<double> MeshScanner::any_number(std::string_view word) {
  std::optional<double> value = number(word);
  if (value || word.size() > 40) return value;
  const std::size_t sign = word.find_first_of("dD");
  if (sign == word.npos) return {};
  std::string usual(word);
  usual[sign] = 'e';
  value = number(usual);
  if (value) fortran_.add(line_);
  return value;
}

void MeshScanner::refuse_number(std::string_view word) const {
  const std::size_t comma = word.find(',');
  const bool decimal = comma != word.npos && comma + 1 < word.size() &&
                       word.find_first_not_of("+-0123456789,eE") == word.npos;
  refuse(shown(word) + " is not a number" + (decimal ? ": decimals take a point, no comma" : ""));
}

double MeshScanner::coordinate() {
  const std::string_view w = word();
  if (w.empty()) refuse("three coordinates expected");
  const std::optional<double> value = any_number(w);
  if (!value) refuse_number(w);
  if (!std::isfinite(*value)) refuse("the coordinate " + shown(w) + " is not finite");
  return *value;
}

void MeshScanner::check_number() {
  const std::string_view w = word();
  if (w.empty()) refuse("the line ends too early");
  if (!any_number(w)) refuse_number(w);
}

std::int64_t MeshScanner::integer(std::string_view word, const char* what) {
  const std::string_view w = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
  if (error == std::errc() && end == w.data() + w.size()) return value;
  if (word.empty()) refuse(std::string("the line ends where ") + what + " is expected");
  const std::optional<double> real = any_number(w);
  constexpr double exact = 9007199254740992;  // 2^53: all whole numbers below are doubles
  if (!real || !(std::abs(*real) < exact) || *real != std::floor(*real))
    refuse(shown(word) + " is not " + what);
  whole_.add(line_);
  return static_cast<std::int64_t>(*real);
}

std::uint64_t MeshScanner::count(const char* what) {
  const std::string_view w = word();
  const std::int64_t value = integer(w, what);
  if (value < 0) refuse(shown(w) + " is not " + what);
  return static_cast<std::uint64_t>(value);
}

std::uint64_t MeshScanner::index(std::string_view word, std::uint64_t vertices) {
  const std::int64_t value = integer(word, "a vertex index");
  if (value < 0 || static_cast<std::uint64_t>(value) >= vertices)
    refuse("vertex index " + std::to_string(value) + " is out of range (0 to " +
           std::to_string(vertices - 1) + ")");
  return static_cast<std::uint64_t>(value);
}

void MeshScanner::drop_end_marks() {
  end_marks_ = end_marks(text_.substr(next_));
  text_.remove_suffix(end_marks_);
  lf_ = std::min(lf_, text_.size());
  cr_ = std::min(cr_, text_.size());
}

void MeshScanner::remark_to(Remarks& remarks) const {
  remark(remarks, "line", whole_, "whole number written with a point",
         "whole numbers written with a point");
  remark(remarks, "line", fortran_, "number with the exponent sign D of Fortran",
         "numbers with the exponent sign D of Fortran");
  remark_on_bytes(remarks, end_marks_, "the end of the text (NUL, Ctrl-Z)");
}

void MeshScanner::refuse(const std::string& reason) const { refuse_at(line_, reason); }

void MeshScanner::refuse_at(std::size_t line, const std::string& reason) const {
  throw InputError::at_line(file_, std::max<std::size_t>(1, line), reason);
}

}  // namespace sonde
