// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "engine/base/error.hpp"

namespace sonde {

/// An element of an XML file as it opens.
struct XmlElement {
  std::string_view name;    ///< without its prefix
  const char** attributes;  ///< names and values in turn, a null at the end
  std::size_t line;

  /// Empty where there is none. `name` is as it is written; where none is, without its prefix.
  std::string_view attribute(std::string_view name) const;
};

struct XmlHandlers {
  std::function<void(const XmlElement&)> begin = {};
  std::function<void(std::string_view name)> end = {};
  std::function<void(std::string_view text)> text = {};
};

/// Walks through an XML file. Throws InputError with the line where it is not well formed, declares
/// entities (none of the formats read has any, and they multiply), or is nested deeper than 200
/// elements; and what a handler throws. Throws Cancelled where progress returns false.
void walk_xml(const std::string& file, std::string_view bytes, const XmlHandlers& handlers,
              const Progress& progress);

}  // namespace sonde
