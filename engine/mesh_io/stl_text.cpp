// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "engine/base/progress.hpp"
#include "engine/mesh_io/mesh_scan.hpp"
#include "engine/mesh_io/stl_parts.hpp"

namespace sonde {
namespace {

bool same_word(std::string_view a, std::string_view lower) {
  return std::ranges::equal(
      a, lower, [](char x, char y) { return (x >= 'A' && x <= 'Z' ? x - 'A' + 'a' : x) == y; });
}

/// Some programs put a line with a colour where others have none.
bool is_colour(std::string_view word) { return same_word(word, "color"); }

/// Goes to the next line and returns its first word.
std::string_view next_keyword(MeshScanner& scan, std::string_view expected) {
  if (!scan.next_line()) scan.refuse(shown(expected) + " is expected, but the file ends");
  return scan.word();
}

void check_keyword(const MeshScanner& scan, std::string_view word, std::string_view expected) {
  if (!same_word(word, expected)) scan.refuse(shown(expected) + " is expected, not " + shown(word));
}

/// Goes to the next line, which must start with the keyword.
void expect(MeshScanner& scan, std::string_view keyword) {
  check_keyword(scan, next_keyword(scan, keyword), keyword);
}

void expect_after_colours(MeshScanner& scan, std::string_view keyword) {
  std::string_view word = next_keyword(scan, keyword);
  while (is_colour(word)) word = next_keyword(scan, keyword);
  check_keyword(scan, word, keyword);
}

void end_of_line(MeshScanner& scan) {
  const std::string_view word = scan.word();
  if (!word.empty()) scan.refuse("unexpected " + shown(word));
}

/// The rest of a facet; its normal is not looked at: that of a sliver may well be no number.
void read_facet(MeshScanner& scan, std::vector<Vec3>& corners) {
  if (!same_word(scan.word(), "normal") || scan.skip_words() != 3)
    scan.refuse("\"facet normal\" and three numbers are expected");
  expect_after_colours(scan, "outer");
  if (!same_word(scan.word(), "loop")) scan.refuse("\"outer loop\" is expected");
  for (int corner = 0; corner < 3; ++corner) {
    expect(scan, "vertex");
    corners.push_back(scan.point());
    end_of_line(scan);
  }
  expect(scan, "endloop");
  expect(scan, "endfacet");
}

}  // namespace

PolygonSoup read_text_stl(const std::string& file, std::string_view text,
                          const Progress& progress) {
  const Progress walking = part_of(progress, 0, 0.6);
  MeshScanner scan(file, text, '\0', false, walking);
  scan.drop_end_marks();
  std::vector<Vec3> corners;
  bool inside = false;  // of a solid; a file may hold several, one after the other
  while (scan.next_line()) {
    const std::string_view word = scan.word();
    if (!inside && same_word(word, "solid")) {
      inside = true;
    } else if (inside && same_word(word, "facet")) {
      read_facet(scan, corners);
    } else if (inside && same_word(word, "endsolid")) {
      inside = false;
    } else if (!is_colour(word)) {
      scan.refuse(inside ? "\"facet\" or \"endsolid\" is expected, not " + shown(word)
                         : "data outside of a solid: " + shown(word));
    }
  }
  if (corners.empty()) {
    if (inside) scan.refuse("the file ends before \"endsolid\"");
    throw InputError::in(file, "the mesh has no triangles");
  }
  PolygonSoup soup = join_corners(corners, part_of(progress, 0.6, 1));
  if (inside)
    soup.remarks.push_back("line " + std::to_string(scan.line()) +
                           ": the file ends before \"endsolid\"; is it whole?");
  scan.remark_to(soup.remarks);
  return soup;
}

}  // namespace sonde
