// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/located_json.hpp"
#include "engine/text/nearest.hpp"

namespace sonde {

/// Reads the text of one scene file in a single pass over its values: each is checked where it is
/// read. Errors are InputErrors with the file's name and the line. Used by scene.cpp only.
struct SceneReader {
  using Kind = JsonNode::Kind;
  using Keys = std::vector<std::string_view>;

  std::filesystem::path file;
  std::filesystem::path within = {};  ///< the folder that its paths must stay in; empty: any
  /// Collects paths out of the folder, instead of refusing them; then no file of gains is read.
  std::vector<std::filesystem::path>* outside = nullptr;

  Scene scene(const std::string& text) const;
  /// The text of a file that holds only a scene's `coupling` object.
  Coupling coupling(const std::string& text) const;
  /// Every key that scene() accepts (scene_keys()).
  static std::vector<std::string> keys();

 private:
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

  std::optional<int> format(const JsonNode& root) const;
  double unit(const JsonNode& node) const;
  std::filesystem::path path(const JsonNode& node) const;
  Pose pose(const JsonNode& node, double unit) const;
  /// One mesh, or a list of meshes that belong together.
  SceneBody body(const JsonNode& node, double unit) const;
  SceneBody mesh(const JsonNode& node, double unit, const Keys& known) const;
  /// Reads the keys that only parts have.
  void read_part(const JsonNode& node, SceneBody& part) const;
  void read_flag(const JsonNode& node, std::string_view key, bool& flag) const;
  /// The outward offset of the probe's faces, negative inwards, m.
  double offset(const JsonNode& root, double unit) const;
  /// The gains, or the path of a file that contains them.
  Coupling coupling_or_path(const JsonNode& node) const;
  Coupling coupling(const JsonNode& node) const;
  ServoSettings servo(const JsonNode& node) const;
  /// An id is kept unchanged; a text that ends in ".json" is a path like the others.
  std::string profile(const JsonNode& node) const;
  SceneDevice device(const JsonNode& node) const;
};

}  // namespace sonde
