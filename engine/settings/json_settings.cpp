// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/settings/json_settings.hpp"

#include "engine/text/nearest.hpp"

namespace sonde {

std::size_t read_choice(const std::filesystem::path& file, const JsonNode& node,
                        std::span<const Choice> choices) {
  expect_kind(file, node, JsonNode::Kind::string);
  const auto place = place_of(choices, node.text);
  if (!place)
    fail_at(file, node.line,
            in_quotes(node.key) + " is " + in_quotes(node.text) + "; the nearest known value is " +
                in_quotes(nearest(node.text, keys_of(choices))));
  return *place;
}

}  // namespace sonde
