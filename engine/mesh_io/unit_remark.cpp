// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/unit_remark.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "engine/text/file_unit.hpp"

namespace sonde {
namespace {

/// The words of a unit that files use, besides its name and plural.
struct OtherWords {
  std::string_view name;
  std::string_view words;  ///< each between blanks
};
constexpr OtherWords other_words[] = {{"m", " meter meters metre "},
                                      {"cm", " centimeter centimeters centimetre "},
                                      {"mm", " millimeter millimeters millimetre "},
                                      {"um", " micron microns micrometer micrometers micrometre "},
                                      {"in", " inch "},
                                      {"ft", " foot "}};

constexpr std::size_t text_looked_at = 1 << 14;  // bytes: a header, not all the comments of a mesh

bool is_letter(char c) { return (c | 0x20) >= 'a' && (c | 0x20) <= 'z'; }
bool is_blank(char c) { return c == ' ' || c == '\t'; }

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c | 0x20);
  return out;
}

const FileUnit* unit_of(std::string_view word) {
  const std::string padded = " " + std::string(word) + " ";
  const auto* const other = std::ranges::find_if(other_words, [&](const OtherWords& unit) {
    return unit.words.find(padded) != std::string_view::npos;
  });
  const std::string_view name = other == std::end(other_words) ? word : other->name;
  const auto found = std::ranges::find_if(
      file_units(), [&](const FileUnit& unit) { return unit.name == name || unit.plural == name; });
  return found == file_units().end() ? nullptr : &*found;
}

/// A unit that is stated, and the words that do.
struct Stated {
  const FileUnit* unit;
  std::string_view words;
};

/// Takes words one after another off a line in lower case.
struct Words {
  std::string_view line;
  std::size_t at = 0;

  void skip_blanks() {
    while (at < line.size() && is_blank(line[at])) ++at;
  }
  bool take(char c) {
    skip_blanks();
    if (at == line.size() || line[at] != c) return false;
    ++at;
    return true;
  }
  std::string_view word() {
    skip_blanks();
    const std::size_t from = at;
    while (at < line.size() && is_letter(line[at])) ++at;
    return line.substr(from, at - from);
  }
};

/// What follows the word "unit" or "units": a sign or "are", "in", and the name of a unit.
const FileUnit* unit_after(Words& words) {
  const bool sign = words.take(':') || words.take('=');
  const bool quoted = words.take('"') || words.take('\'');
  std::string_view word = words.word();
  const bool bare = word == "in" && !sign && !quoted;  // "units in mm", and no inches
  if (word == "are" || word == "is" || bare) word = words.word();
  const bool goes_on =
      words.at < words.line.size() && words.line[words.at] >= '0' && words.line[words.at] <= '9';
  return goes_on ? nullptr : unit_of(word);
}

/// `lower` is the line in lower case.
std::optional<Stated> stated_in(std::string_view line, std::string_view lower) {
  for (std::size_t at = lower.find("unit"); at != lower.npos; at = lower.find("unit", at + 1)) {
    if (at > 0 && is_letter(lower[at - 1])) continue;
    Words words{lower, at + 4};
    if (words.at < lower.size() && lower[words.at] == 's') ++words.at;
    if (words.at < lower.size() && is_letter(lower[words.at])) continue;
    if (const FileUnit* unit = unit_after(words))
      return Stated{unit, line.substr(at, words.at - at)};
  }
  return {};
}

/// Calls look(line) until it returns true.
template <class Look>
void for_lines(std::string_view text, const Look& look) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    if (look(text.substr(0, end))) return;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

bool may_state(UnitPlace place, std::string_view line) {
  if (place == UnitPlace::comments) return line.starts_with('#');
  if (place == UnitPlace::ply_header)
    return line.starts_with("comment") || line.starts_with("obj_info");
  return true;
}

std::string_view head_of(UnitPlace place, std::string_view bytes) {
  constexpr std::size_t stl_header = 80;
  if (place != UnitPlace::stl_header) return bytes.substr(0, text_looked_at);
  return bytes.substr(0, std::min(stl_header, bytes.find('\n')));
}

std::optional<Stated> find_stated(UnitPlace place, std::string_view bytes) {
  std::optional<Stated> found;
  for_lines(head_of(place, bytes), [&](std::string_view line) {
    if (may_state(place, line)) found = stated_in(line, lower_case(line));
    return found || (place == UnitPlace::ply_header && line.starts_with("end_header"));
  });
  return found;
}

}  // namespace

void remark_on_unit(PolygonSoup& soup, UnitPlace place, std::string_view bytes, double scale) {
  const auto read_as = std::ranges::find(file_units(), scale, &FileUnit::metres);
  if (read_as == file_units().end()) return;
  const std::optional<Stated> stated = find_stated(place, bytes);
  if (!stated || stated->unit == &*read_as) return;
  std::string words(stated->words);
  std::erase_if(words, [](char c) { return c == '"' || c == '\''; });
  soup.remarks.push_back("the file says \"" + words + "\"; read as " +
                         std::string(read_as->plural) + "; --unit " +
                         std::string(stated->unit->name) + " takes it at its word");
}

}  // namespace sonde
