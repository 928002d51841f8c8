// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/error.hpp"
#include "engine/geometry/pose.hpp"
#include "engine/mesh_io/remarks.hpp"

namespace sonde {

/// Walks through the lines and words of a text mesh file and knows the line for error messages. It
/// skips blank lines, and what follows a comment sign. LF, CRLF and CR alone end a line, as they
/// come.
class MeshScanner {
 public:
  /// `comment` is the sign that starts a comment ('\0': none). Where `continues` is set, a
  /// backslash at the end of a line joins the next, also with blanks after it.
  MeshScanner(const std::string& file, std::string_view text, char comment, bool continues,
              const Progress& progress);

  /// Goes to the next line that has a word; false at the end.
  bool next_line();
  /// The next word of the line; empty at its end.
  std::string_view word();
  /// True where the line has more words.
  bool has_word();
  /// The rest of the words of the line, counted.
  std::size_t skip_words();
  /// Where binary data starts after this line, in bytes: its end is as that of the first line.
  std::size_t position() const { return cr_alone_ ? std::min(line_end_ + 1, next_) : next_; }
  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return text_.size() - next_; }

  std::size_t bytes_in_line() const { return end_ - at_; }

  /// The next word as a coordinate: finite. One too small for a double is 0.
  double coordinate();
  Vec3 point() {  // in this order
    const double x = coordinate(), y = coordinate(), z = coordinate();
    return {x, y, z};
  }
  /// The next word as a number (finite or not), passed over.
  void check_number();
  /// The next word as a whole number of at least zero; `what` says what it should be.
  std::uint64_t count(const char* what);
  /// A word as a whole number, "3.0" as well; refuses the line where it is none.
  std::int64_t integer(std::string_view word, const char* what);
  /// A vertex index, from 0, below `vertices`.
  std::uint64_t index(std::uint64_t vertices) { return index(word(), vertices); }
  std::uint64_t index(std::string_view word, std::uint64_t vertices);

  /// Leaves out what follows the text at its end: see end_marks. For text alone.
  void drop_end_marks();
  /// Says what was odd about the numbers, and what followed the text.
  void remark_to(Remarks& remarks) const;

  [[noreturn]] void refuse(const std::string& reason) const;
  [[noreturn]] void refuse_at(std::size_t line, const std::string& reason) const;

 private:
  bool is_blank(char c) const;
  void report() const;
  void find_line_end();
  void take_line_end();
  bool ends_in_backslash() const;
  std::optional<double> any_number(std::string_view word);
  [[noreturn]] void refuse_number(std::string_view word) const;

  const std::string& file_;
  std::string_view text_;
  char comment_;
  bool continues_;
  const Progress& progress_;
  std::size_t at_ = 0;           ///< in the line
  std::size_t end_ = 0;          ///< of the line, without its comment
  std::size_t line_end_ = 0;     ///< of the line, with its comment
  std::size_t lf_ = 0, cr_ = 0;  ///< the next of each that is not yet passed, or the end
  std::size_t next_ = 0;         ///< start of the next line
  std::size_t line_ = 0;         ///< number of the line, from 1
  std::size_t next_number_ = 1;  ///< number of the next line
  std::size_t lines_seen_ = 0;
  bool cr_alone_ = false;  ///< ends the first line
  Tally whole_, fortran_;  ///< "3.0" for 3, and "1D0" for 1e0
  std::size_t end_marks_ = 0;
};

/// A word as a number: infinite where it is too large, 0 where it is too small for a double; none
/// where it is no number.
std::optional<double> number(std::string_view word);

/// A word for a message: short, and without control characters.
std::string shown(std::string_view word);

}  // namespace sonde
