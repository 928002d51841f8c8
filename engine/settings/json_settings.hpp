// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/settings/settings.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {

/// The keys of a table, to check an object's against.
template <class Row>
std::vector<std::string_view> keys_of(std::span<const Row> table) {
  std::vector<std::string_view> keys;
  for (const Row& row : table) keys.emplace_back(row.key);
  return keys;
}

/// Reads the settings of a table that the object holds; the others stay as they are. Throws
/// InputError with the file, the line and the reason: a value that is no number or out of range.
template <class Target>
void read_settings(const std::filesystem::path& file, const JsonNode& object,
                   std::span<const Setting> settings, Target& target) {
  for (const Setting& setting : settings) {
    const JsonNode* node = object.find(setting.key);
    if (!node) continue;
    expect_kind(file, *node, JsonNode::Kind::number);
    if (!allowed(setting, node->number))
      fail_at(file, node->line,
              in_quotes(setting.key) + " is " + number_text(node->number) + "; it must be " +
                  range_text(setting));
    set(target, setting.key, node->number);
  }
}

/// The choice that the node names. Throws InputError that names the nearest.
std::size_t read_choice(const std::filesystem::path& file, const JsonNode& node,
                        std::span<const Choice> choices);

}  // namespace sonde
