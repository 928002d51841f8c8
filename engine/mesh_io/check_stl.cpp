// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "engine/mesh_io/mesh_checks.hpp"
#include "engine/mesh_io/mesh_scan.hpp"

namespace sonde {
namespace {

bool same_word(std::string_view a, std::string_view lower) {
  return std::ranges::equal(
      a, lower, [](char x, char y) { return (x >= 'A' && x <= 'Z' ? x - 'A' + 'a' : x) == y; });
}

/// Goes to the next line, which must start with the keyword.
void expect(MeshScanner& scan, std::string_view keyword) {
  const std::string expected = shown(keyword) + " is expected";
  if (!scan.next_line()) scan.refuse(expected + ", but the file ends");
  const std::string_view word = scan.word();
  if (!same_word(word, keyword)) scan.refuse(expected + ", not " + shown(word));
}

void end_of_line(MeshScanner& scan) {
  const std::string_view word = scan.word();
  if (!word.empty()) scan.refuse("unexpected " + shown(word));
}

/// The rest of a facet; its normal is not looked at: that of a sliver may well be no number.
void check_facet(MeshScanner& scan, std::string& out) {
  if (!same_word(scan.word(), "normal") || scan.skip_words() != 3)
    scan.refuse("\"facet normal\" and three numbers are expected");
  out += "facet\n";
  expect(scan, "outer");
  if (!same_word(scan.word(), "loop")) scan.refuse("\"outer loop\" is expected");
  for (int corner = 0; corner < 3; ++corner) {
    expect(scan, "vertex");
    out += "vertex";
    for (int k = 0; k < 3; ++k) scan.copy_coordinate(out);
    out += '\n';
    end_of_line(scan);
  }
  expect(scan, "endloop");
  expect(scan, "endfacet");
  out += "endfacet\n";
}

}  // namespace

CheckedMesh check_text_stl(const std::string& file, std::string_view text,
                           const Progress& progress) {
  MeshScanner scan(file, text, '\0', false, progress);
  CheckedMesh out;
  out.text.reserve(text.size());
  out.text = "solid\n";
  bool inside = false;  // of a solid; a file may hold several, one after the other
  while (scan.next_line()) {
    const std::string_view word = scan.word();
    if (!inside && same_word(word, "solid")) {
      inside = true;
    } else if (inside && same_word(word, "facet")) {
      check_facet(scan, out.text);
      ++out.polygons;
    } else if (inside && same_word(word, "endsolid")) {
      inside = false;
    } else {
      scan.refuse(inside ? "\"facet\" or \"endsolid\" is expected, not " + shown(word)
                         : "data outside of a solid: " + shown(word));
    }
  }
  if (inside) scan.refuse("the file ends before \"endsolid\"");
  if (out.polygons == 0) throw InputError::in(file, "the mesh has no triangles");
  out.text += "endsolid\n";
  return out;
}

}  // namespace sonde
