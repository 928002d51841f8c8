// SPDX-License-Identifier: GPL-3.0-or-later
// References: lines written out here.
#include "engine/text/csv_rows.hpp"

#include <gmock/gmock.h>

#include <stdexcept>
#include <vector>

#include "tests/support/complaint.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::string_view columns[] = {"a", "b"};
using Rows = std::vector<std::vector<double>>;

Rows rows_of(const std::filesystem::path& file) {
  Rows rows;
  read_csv_rows(file, columns, 100, [&](std::span<const double> row) {
    if (row[0] > 1e6) throw std::invalid_argument("a is too large");
    rows.emplace_back(row.begin(), row.end());
  });
  return rows;
}
std::string complaint(const std::string& text) {
  return test::complaint_of(text, "rows.csv", rows_of);
}

TEST(CsvRows, gives_every_row_below_the_header) {
  const test::TempFolder folder;
  EXPECT_THAT(rows_of(folder.write("r.csv", "a,b\r\n1,2\r\n+0.5,-1e3\n\n")),
              ElementsAre(ElementsAre(1, 2), ElementsAre(0.5, -1000)));
}

TEST(CsvRows, a_byte_that_is_no_text_neither_cuts_the_reason_nor_reaches_the_terminal) {
  using namespace std::string_literals;
  EXPECT_THAT(complaint("a,b\n1,.2\0005\n"s),
              StartsWith("2: b is \".2\\x005\", which is not a finite number"));
  EXPECT_THAT(complaint("a\0,b\n"s), StartsWith("1: the header is \"a\\x00,b\"; expected \"a,b\""));
  EXPECT_THAT(complaint("a,b\n1,\x1b[2J\n"), HasSubstr("\"\\x1b[2J\""));
}

// What a spreadsheet saves as "Unicode text": two bytes a letter, with and without a mark.
TEST(CsvRows, utf16_is_named_as_such) {
  using namespace std::string_literals;
  for (const std::string& text : {"\xFF\xFE"
                                  "a\0,\0b\0\n\0"s,
                                  "\xFE\xFF\0a\0,\0b\0\n"s, "a\0,\0b\0\n\0"s, "\0a\0,\0b\0\n"s})
    EXPECT_THAT(complaint(text), HasSubstr("is UTF-16 text; save it as UTF-8"));
}

TEST(CsvRows, names_the_line_and_the_reason) {
  EXPECT_THAT(complaint("b,a\n"), StartsWith("1: the header is \"b,a\"; expected \"a,b\""));
  EXPECT_THAT(complaint("a,b\n1\n"), StartsWith("2: 1 columns; expected 2"));
  EXPECT_THAT(complaint("a,b\n1,2,3\n"), StartsWith("2: 3 columns; expected 2"));
  EXPECT_THAT(complaint("a,b\n1,2\n1,0x2\n"), StartsWith("3: b is \"0x2\""));
  EXPECT_THAT(complaint("a,b\n1,nan\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(complaint("a,b\n\n1,2\n"), StartsWith("2: a blank line"));
  EXPECT_THAT(complaint("a,b\n1e7,2\n"), StartsWith("2: a is too large"));
  EXPECT_THAT(complaint("a,b\n" + std::string(100, '1') + ",2\n"), HasSubstr("100"));
}

TEST(CsvRows, times_must_rise) {
  EXPECT_NO_THROW(expect_later(1.5, 1));
  EXPECT_THROW(expect_later(1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace sonde
