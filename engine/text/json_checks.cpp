// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/text/json_checks.hpp"

#include <algorithm>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/text/nearest.hpp"
#include "engine/text/printable.hpp"

namespace sonde {

std::string in_quotes(std::string_view text) {
  const bool fits = text.size() <= 60;
  return '"' + printable(text.substr(0, fits ? 60 : 57)) + (fits ? "\"" : "...\"");
}

void fail_at(const std::filesystem::path& file, std::size_t line, const std::string& reason) {
  throw InputError::at_line(file.string(), line, reason);
}

void expect_kind(const std::filesystem::path& file, const JsonNode& node, JsonNode::Kind kind) {
  if (node.kind == kind) return;
  const std::string what = node.key.empty() ? "the file's value" : in_quotes(node.key);
  fail_at(file, node.line, what + " is " + name_of(node.kind) + "; expected " + name_of(kind));
}

void expect_keys(const std::filesystem::path& file, const JsonNode& node,
                 std::span<const std::string_view> known) {
  expect_kind(file, node, JsonNode::Kind::object);
  for (const JsonNode& child : node.children)
    if (std::ranges::find(known, child.key) == known.end())
      fail_at(file, child.key_line,
              "unknown key " + in_quotes(child.key) + "; the nearest known one is " +
                  in_quotes(nearest(child.key, known)));
}

const JsonNode& need_key(const std::filesystem::path& file, const JsonNode& object,
                         std::string_view key, std::string_view whole) {
  const JsonNode* found = object.find(key);
  if (!found)
    fail_at(file, object.line,
            "key " + in_quotes(key) + " is missing from " +
                (object.key.empty() ? std::string(whole) : in_quotes(object.key)));
  return *found;
}

void expect_file(const std::filesystem::path& file, std::size_t line, std::string_view key,
                 const std::filesystem::path& named) {
  std::error_code ignored;
  if (!std::filesystem::exists(named, ignored))
    fail_at(file, line, in_quotes(key) + " names " + named.string() + ": no such file");
}

}  // namespace sonde
