// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/gltf_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/mesh_io/assets/copies.hpp"
#include "engine/mesh_io/assets/glb.hpp"
#include "engine/text/counted.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/located_json.hpp"

namespace sonde {
namespace {

using nlohmann::json;
using Kind = JsonNode::Kind;
using namespace std::string_view_literals;

constexpr double largest_count = 1e15;  // whole, as a double
/// Extensions that a file may require: they bear on looks alone.
constexpr std::array known_extensions = {
    "KHR_materials_unlit"sv,   "KHR_texture_transform"sv, "KHR_texture_basisu"sv,
    "EXT_texture_webp"sv,      "KHR_lights_punctual"sv,   "KHR_materials_pbrSpecularGlossiness"sv,
    "KHR_materials_variants"sv};

class ShapeReader {
 public:
  ShapeReader(const std::string& file, std::string_view text, std::size_t data, bool binary)
      : file_(file), root_(parse_json(file, text)), data_(data), binary_(binary) {
    if (root_.kind != Kind::object) throw InputError::in(file, "not a glTF file");
  }

  json read() {
    out_["asset"] = {{"version", "2.0"}};
    check_version();
    check_extensions();
    read_buffers();
    read_views();
    read_accessors();
    read_meshes();
    read_nodes();
    read_scenes();
    return std::move(out_);
  }
  std::vector<std::string> remarks;
  std::uint64_t triangles() const { return triangles_; }

 private:
  [[noreturn]] void refuse(const JsonNode& node, const std::string& why) const {
    throw InputError::at_line(file_, node.line, why);
  }
  /// The elements of an array of the file's own; none where there is no such array.
  const std::vector<JsonNode>& elements(const JsonNode& of, const char* key,
                                        Kind kind = Kind::object) const {
    static const std::vector<JsonNode> none;
    const JsonNode* array = of.find(key);
    if (!array) return none;
    expect_kind(file_, *array, Kind::array);
    for (const JsonNode& node : array->children) expect_kind(file_, node, kind);
    return array->children;
  }
  std::uint64_t whole(const JsonNode& node) const {
    expect_kind(file_, node, Kind::number);
    if (!(node.number >= 0 && node.number <= largest_count) ||
        node.number != std::floor(node.number))
      refuse(node, in_quotes(node.key) + " is no count");
    return static_cast<std::uint64_t>(node.number);
  }
  std::uint64_t whole(const JsonNode& of, const char* key, std::uint64_t otherwise) const {
    const JsonNode* node = of.find(key);
    return node ? whole(*node) : otherwise;
  }
  std::uint64_t needed(const JsonNode& of, const char* key) const {
    return whole(need_key(file_, of, key, "the file"));
  }
  std::size_t index(const JsonNode& node, std::size_t count, const char* what) const {
    const std::uint64_t at = whole(node);
    if (at >= count)
      refuse(node, std::string(what) + " " + std::to_string(at) + " is named, and there are " +
                       std::to_string(count));
    return at;
  }
  std::size_t index(const JsonNode& of, const char* key, std::size_t count,
                    const char* what) const {
    return index(need_key(file_, of, key, "the file"), count, what);
  }

  void check_version() const {
    const JsonNode* asset = root_.find("asset");
    const JsonNode* version = asset ? asset->find("version") : nullptr;
    if (!version || version->kind != Kind::string)
      throw InputError::in(file_, "not a glTF file: it says no version");
    if (!version->text.starts_with("2."))
      refuse(*version, "version " + in_quotes(version->text) + " of glTF: 2.0 is read");
  }

  void check_extensions() {
    for (const JsonNode& name : elements(root_, "extensionsRequired", Kind::string))
      if (std::ranges::find(known_extensions, name.text) == known_extensions.end())
        refuse(name,
               "the file requires the extension " + in_quotes(name.text) + ", which is not read");
    for (const JsonNode& name : elements(root_, "extensionsUsed", Kind::string)) {
      if (name.text == "EXT_mesh_gpu_instancing")
        refuse(name, "the file places copies by EXT_mesh_gpu_instancing, which is not read");
    }
    if (!elements(root_, "skins").empty())
      remarks.push_back(counted(root_.find("skins")->children.size(), "skin") +
                        " not applied: meshes are as they were bound");
  }

  void read_buffers() {
    for (const JsonNode& buffer : elements(root_, "buffers")) {
      const std::uint64_t size = needed(buffer, "byteLength");
      json kept = {{"byteLength", size}};
      if (const JsonNode* uri = buffer.find("uri")) {
        expect_kind(file_, *uri, Kind::string);
        if (!uri->text.starts_with("data:"))
          refuse(*uri, "the data lie in another file, " + in_quotes(uri->text) +
                           ": save it as GLB, or with the data inside");
        const std::size_t comma = uri->text.find(";base64,");
        if (comma == uri->text.npos) refuse(*uri, "data that are not in base64");
        // Four letters for three bytes; a last group may be filled up.
        if (size > (uri->text.size() - comma) / 4 * 3) refuse(*uri, "the data are cut off");
        kept["uri"] = uri->text;
      } else if (!binary_ || !buffers_.empty()) {
        refuse(buffer, "a buffer without data");
      } else if (size > data_) {
        refuse(buffer, "the buffer declares " + std::to_string(size) + " bytes, and there are " +
                           std::to_string(data_));
      }
      buffers_.push_back(size);
      out_["buffers"].push_back(std::move(kept));
    }
  }

  void read_views() {
    for (const JsonNode& view : elements(root_, "bufferViews")) {
      const std::size_t buffer = index(view, "buffer", buffers_.size(), "buffer");
      const std::uint64_t begin = whole(view, "byteOffset", 0), size = needed(view, "byteLength");
      if (begin > buffers_[buffer] || size > buffers_[buffer] - begin)
        refuse(view, "a view of a buffer ends after the buffer");
      const std::uint64_t stride = whole(view, "byteStride", 0);
      if (stride != 0 && (stride < 4 || stride > 252)) refuse(view, "a stride of no glTF");
      json kept = {{"buffer", buffer}, {"byteOffset", begin}, {"byteLength", size}};
      if (stride != 0) kept["byteStride"] = stride;
      views_.push_back({size, stride});
      out_["bufferViews"].push_back(std::move(kept));
    }
  }

  static std::uint64_t size_of(std::uint64_t component) {
    switch (component) {
      case 5120:
      case 5121:
        return 1;
      case 5122:
      case 5123:
        return 2;
      case 5125:
      case 5126:
        return 4;
      default:
        return 0;
    }
  }

  /// A view with room for so many elements of so many bytes.
  std::size_t room(const JsonNode& of, std::uint64_t begin, std::uint64_t count,
                   std::uint64_t bytes) const {
    const std::size_t view = index(of, "bufferView", views_.size(), "view");
    const std::uint64_t stride = views_[view].stride != 0 ? views_[view].stride : bytes;
    if (begin > views_[view].size || bytes > views_[view].size - begin ||
        (count - 1) > (views_[view].size - begin - bytes) / stride)
      refuse(of, std::to_string(count) + " elements are declared, and their data are shorter");
    return view;
  }

  struct Accessor {
    std::uint64_t count = 0, component = 0;
    bool vector = false;
  };

  void read_accessors() {
    static constexpr std::array<std::pair<std::string_view, std::uint64_t>, 7> types = {
        {{"SCALAR", 1},
         {"VEC2", 2},
         {"VEC3", 3},
         {"VEC4", 4},
         {"MAT2", 4},
         {"MAT3", 9},
         {"MAT4", 16}}};
    for (const JsonNode& node : elements(root_, "accessors")) {
      Accessor accessor{.count = needed(node, "count"), .component = needed(node, "componentType")};
      const JsonNode& type = need_key(file_, node, "type", "the file");
      const auto found = std::ranges::find(types, type.text, &decltype(types)::value_type::first);
      const std::uint64_t bytes = size_of(accessor.component);
      if (found == types.end() || bytes == 0 || accessor.count == 0)
        refuse(node, "an accessor of no glTF");
      accessor.vector = found->first == "VEC3";
      const std::uint64_t begin = whole(node, "byteOffset", 0);
      json kept = {{"count", accessor.count},
                   {"componentType", accessor.component},
                   {"type", found->first},
                   {"byteOffset", begin}};
      // Those of compressed data have none, and no view is an array of zeros of any length.
      if (!node.find("bufferView")) refuse(node, "an accessor without data");
      kept["bufferView"] = room(node, begin, accessor.count, bytes * found->second);
      if (node.find("sparse")) refuse(*node.find("sparse"), "sparse data are not read");
      accessors_.push_back(accessor);
      out_["accessors"].push_back(std::move(kept));
    }
  }

  /// Its corners.
  std::uint64_t read_primitive(const JsonNode& primitive, json& kept) {
    const JsonNode& attributes = need_key(file_, primitive, "attributes", "the file");
    expect_kind(file_, attributes, Kind::object);
    if (!attributes.find("POSITION")) return 0;
    const std::size_t points = index(attributes, "POSITION", accessors_.size(), "accessor");
    if (!accessors_[points].vector || accessors_[points].component != 5126)
      refuse(primitive, "positions that are not three floats are not read");
    kept["attributes"]["POSITION"] = points;
    const std::uint64_t mode = whole(primitive, "mode", 4);
    if (mode > 6) refuse(primitive, "a mode of no glTF");
    if (mode < 4) {
      ++thin_;
      return 0;
    }
    kept["mode"] = mode;
    std::uint64_t corners = accessors_[points].count;
    if (primitive.find("indices")) {
      const std::size_t indices = index(primitive, "indices", accessors_.size(), "accessor");
      const Accessor& accessor = accessors_[indices];
      if (accessor.component != 5121 && accessor.component != 5123 && accessor.component != 5125)
        refuse(primitive, "indices that are no counts");
      kept["indices"] = indices;
      corners = accessor.count;
    }
    // Each corner of a strip or a fan but the first two makes a triangle.
    return 3 * (mode == 4 ? corners / 3 : corners - std::min<std::uint64_t>(corners, 2));
  }

  void read_meshes() {
    for (const JsonNode& mesh : elements(root_, "meshes")) {
      std::uint64_t corners = 0;
      json kept = {{"primitives", json::array()}};
      for (const JsonNode& primitive : elements(mesh, "primitives")) {
        json its;
        const std::uint64_t more = read_primitive(primitive, its);
        corners += more;
        if (more > 0) kept["primitives"].push_back(std::move(its));
      }
      if (!elements(mesh, "weights", Kind::number).empty()) ++shaped_;
      corners_.push_back(static_cast<double>(corners));
      out_["meshes"].push_back(std::move(kept));
    }
    if (thin_ > 0)
      remarks.push_back(counted(thin_, "set") + " of points or lines left out: they bound nothing");
    if (shaped_ > 0) remarks.push_back("shapes that meshes change to are not read");
  }

  void read_numbers(const JsonNode& node, const char* key, std::size_t count, json& kept) const {
    const std::vector<JsonNode>& numbers = elements(node, key, Kind::number);
    if (numbers.empty()) return;
    if (numbers.size() != count)
      refuse(node, std::string("\"") + key + "\" has " + std::to_string(numbers.size()) +
                       " numbers, not " + std::to_string(count));
    for (const JsonNode& number : numbers) kept[key].push_back(number.number);
  }

  void read_nodes() {
    const std::vector<JsonNode>& nodes = elements(root_, "nodes");
    for (std::size_t k = 0; k < nodes.size(); ++k) copies_.add(0);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      json kept = json::object();
      for (const JsonNode& child : elements(nodes[k], "children", Kind::number)) {
        const std::size_t at = index(child, nodes.size(), "node");
        kept["children"].push_back(at);
        copies_.place(k, at);
      }
      if (nodes[k].find("mesh")) {
        const std::size_t mesh = index(nodes[k], "mesh", corners_.size(), "mesh");
        kept["mesh"] = mesh;
        copies_.add_corners(k, corners_[mesh]);
      }
      read_numbers(nodes[k], "matrix", 16, kept);
      read_numbers(nodes[k], "translation", 3, kept);
      read_numbers(nodes[k], "rotation", 4, kept);
      read_numbers(nodes[k], "scale", 3, kept);
      out_["nodes"].push_back(std::move(kept));
    }
  }

  /// One scene: the file's own choice, or the first; without any, all that nothing places.
  void read_scenes() {
    const std::vector<JsonNode>& scenes = elements(root_, "scenes");
    const std::size_t nodes = elements(root_, "nodes").size();
    const std::size_t all = copies_.add(0);
    json kept = json::array();
    if (scenes.empty()) {
      for (std::size_t k = 0; k < nodes; ++k)
        if (!copies_.is_placed(k)) kept.push_back(k);
    } else {
      const std::size_t chosen =
          root_.find("scene") ? index(root_, "scene", scenes.size(), "scene") : 0;
      for (const JsonNode& node : elements(scenes[chosen], "nodes", Kind::number))
        kept.push_back(index(node, nodes, "node"));
      if (scenes.size() > 1)
        remarks.push_back("scene " + std::to_string(chosen + 1) + " of " +
                          std::to_string(scenes.size()) + " is read");
    }
    for (const json& node : kept) copies_.place(all, node.get<std::size_t>());
    triangles_ = static_cast<std::uint64_t>(copies_.count(file_, all) / 3);
    out_["scene"] = 0;
    out_["scenes"].push_back({{"nodes", std::move(kept)}});
  }

  const std::string& file_;
  JsonNode root_;
  std::size_t data_;
  bool binary_;
  json out_;
  std::vector<std::uint64_t> buffers_;
  struct View {
    std::uint64_t size, stride;
  };
  std::vector<View> views_;
  std::vector<Accessor> accessors_;
  std::vector<double> corners_;  ///< of each mesh
  std::uint64_t triangles_ = 0;
  std::size_t shaped_ = 0, thin_ = 0;
  Copies copies_;
};

}  // namespace

GltfShape gltf_shape(const std::string& file, std::string_view bytes) {
  const bool binary = bytes.starts_with("glTF");
  const Glb glb = binary ? chunks_of(file, bytes) : Glb{bytes, {}};
  ShapeReader reader(file, glb.text, glb.data.size(), binary);
  const std::string text = reader.read().dump();
  // The chunk of a GLB is for a buffer without data of its own.
  const bool chunk = binary && !glb.data.empty();
  return {chunk ? glb_of(text, glb.data) : text, chunk, reader.triangles(),
          std::move(reader.remarks)};
}

}  // namespace sonde
