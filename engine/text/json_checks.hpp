// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "engine/text/located_json.hpp"

namespace sonde {

/// The checks that all readers of JSON files share. The errors are InputErrors with the file, the
/// line and the reason.

/// The text in quotes, printable() and truncated if it is long.
std::string in_quotes(std::string_view text);

[[noreturn]] void fail_at(const std::filesystem::path& file, std::size_t line,
                          const std::string& reason);

void expect_kind(const std::filesystem::path& file, const JsonNode& node, JsonNode::Kind kind);

/// Requires an object without other keys; the error names the nearest known key.
void expect_keys(const std::filesystem::path& file, const JsonNode& node,
                 std::span<const std::string_view> known);

/// The value of a required key. `whole` is the name of the file's own object: "the scene".
const JsonNode& need_key(const std::filesystem::path& file, const JsonNode& object,
                         std::string_view key, std::string_view whole);

/// Requires that the file `named` by a key on that line exists.
void expect_file(const std::filesystem::path& file, std::size_t line, std::string_view key,
                 const std::filesystem::path& named);

}  // namespace sonde
