// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace sonde::test {

/// An element of an XML text.
struct Xml {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< its own, without that of its children
  std::vector<Xml> children;

  /// Throws std::out_of_range where there is none of that name.
  const std::string& operator[](const std::string& attribute) const;
  double number(const std::string& attribute) const;
  /// All elements of a name below this one, in the order of the text; `with_class` only those of a
  /// class.
  std::vector<const Xml*> all(const std::string& named, const std::string& with_class = {}) const;
};

/// The root, read by expat. Throws std::runtime_error with the line where the text is not
/// well-formed.
Xml parse_xml(const std::string& text);

/// Whether an element "text" says just this.
inline bool has_text(const Xml& in, const std::string& text) {
  return std::ranges::any_of(in.all("text"), [&](const Xml* each) { return each->text == text; });
}

}  // namespace sonde::test
