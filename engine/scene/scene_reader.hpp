// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene_body.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/located_json.hpp"
#include "engine/text/nearest.hpp"

namespace sonde {

/// Reads the values of one scene file, including its bodies; its errors are InputErrors with the
/// file's name and the line. Used by scene.cpp only.
struct SceneReader {
  using Kind = JsonNode::Kind;
  using Keys = std::vector<std::string_view>;

  std::filesystem::path file;
  std::filesystem::path within = {};  ///< the folder that its paths must stay in; empty: any
  /// Collects paths out of the folder, instead of refusing them; then no file of gains is read.
  std::vector<std::filesystem::path>* outside = nullptr;

  [[noreturn]] void fail(std::size_t line, const std::string& reason) const;
  void expect(const JsonNode& node, Kind kind) const { expect_kind(file, node, kind); }
  void expect_object(const JsonNode& node, const Keys& known) const {
    expect_keys(file, node, known);
  }
  const JsonNode& need(const JsonNode& object, std::string_view key) const {
    return need_key(file, object, key, "the scene");
  }
  /// One of a few words; `known` is the list for the error message.
  template <class Value>
  Value choice(const JsonNode& node, const std::optional<Value>& value, const Keys& known) const {
    if (value) return *value;
    fail(node.line, in_quotes(node.key) + " is " + in_quotes(node.text) +
                        "; the nearest known value is " + in_quotes(nearest(node.text, known)));
  }

  /// The scene's `format`, if it has one.
  std::optional<int> format(const JsonNode& root) const;
  std::filesystem::path path(const JsonNode& node) const;
  Pose pose(const JsonNode& node, double unit) const;
  /// One mesh, or a list of meshes that belong together.
  SceneBody body(const JsonNode& node, double unit) const;
  /// The outward offset of the probe's faces, negative inwards, m.
  double offset(const JsonNode& root, double unit) const;

 private:
  SceneBody mesh(const JsonNode& node, double unit, const Keys& known) const;
  void read_part(const JsonNode& node, SceneBody& part) const;
  void read_flag(const JsonNode& node, std::string_view key, bool& flag) const;
};

/// The keys of a body of one mesh, and of a part of one of several.
const SceneReader::Keys& body_keys();
const SceneReader::Keys& part_keys();

}  // namespace sonde
