// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sonde {

/// A JSON value with its position in its file, so that an error about its meaning can name the
/// line.
struct JsonNode {
  enum class Kind { null, boolean, number, string, array, object };
  Kind kind = Kind::null;
  std::size_t line = 0;            ///< where the value begins, counted from 1
  std::string text;                ///< a string's value
  double number = 0;               ///< a number's value, finite
  bool boolean = false;            ///< true or false
  std::vector<JsonNode> children;  ///< of an array or an object, in the order of the file
  std::string key;                 ///< the name of a child of an object
  std::size_t key_line = 0;
  std::size_t begin = 0;  ///< an object's or an array's own text is [begin, end) of the file's
  std::size_t end = 0;

  const JsonNode* find(std::string_view name) const;
};

/// Parses JSON text. Throws InputError with `file`, the line and the reason: text that is not JSON,
/// a repeated key, a number too large for a double, or too many levels or keys.
JsonNode parse_json(const std::string& file, std::string_view text);

/// "a string", "an object", ... for messages.
const char* name_of(JsonNode::Kind kind);

}  // namespace sonde
