// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/dae_shape.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "engine/mesh_io/assets/copies.hpp"
#include "engine/mesh_io/assets/xml_walk.hpp"
#include "engine/text/counted.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

class DaeWalk {
 public:
  explicit DaeWalk(const std::string& file) : file_(file), inside_{copies_.add(0)} {}

  DaeShape read(std::string_view bytes, const Progress& progress) {
    walk_xml(file_, bytes,
             {.begin = [&](const XmlElement& element) { begin(element); },
              .end = [&](std::string_view name) { end(name); },
              .text = [&](std::string_view text) { add_text(text); }},
             progress);
    if (!is_collada_) throw InputError::in(file_, "not a COLLADA file");
    for (const auto& [parent, id, line] : placed_) {
      const auto found = objects_.find(id);
      if (found == objects_.end())
        throw InputError::at_line(file_, line, "nothing in the file has the id " + in_quotes(id));
      copies_.place(parent, found->second);
    }
    shape_.corners = static_cast<std::uint64_t>(copies_.count(file_, inside_.front()));
    if (skins_ > 0)
      shape_.remarks.push_back(counted(skins_, "skin") +
                               " not applied: meshes are as they were bound");
    if (others_ > 0)
      shape_.remarks.push_back(counted(others_, "curve or hull") + " not read: no mesh");
    return std::move(shape_);
  }

 private:
  void begin(const XmlElement& element) {
    const std::string_view name = element.name;
    if (name == "COLLADA") is_collada_ = true;
    // The file's own asset comes first; parts of it may say where they come from, too.
    if (name == "unit" && !std::exchange(has_unit_, true)) read_unit(element);
    if (name == "node" || name == "geometry" || name == "controller") open(element);
    if (name == "instance_node" || name == "instance_geometry" || name == "instance_controller")
      place(element, element.attribute("url"));
    if (name == "skin" || name == "morph") {
      ++skins_;
      place(element, element.attribute("source"));
    }
    if (name == "spline" || name == "convex_mesh" || name == "brep") ++others_;
    if (name == "ph") refuse(element, "polygons with holes are not read");
    if (name == "input") stride_ = std::max(stride_, offset_of(element) + 1);
    if (is_primitive(name)) primitive_ = name, stride_ = 0;
    of_indices_ = name == "p";
    if (of_indices_) words_ = 0, in_word_ = false;
  }

  [[noreturn]] void refuse(const XmlElement& element, const std::string& why) const {
    throw InputError::at_line(file_, element.line, why);
  }

  static bool is_primitive(std::string_view name) {
    static constexpr std::string_view all[] = {"triangles", "polylist",   "polygons", "tristrips",
                                               "trifans",   "linestrips", "lines"};
    return std::ranges::find(all, name) != std::end(all);
  }

  std::size_t offset_of(const XmlElement& element) const {
    const std::string_view text = element.attribute("offset");
    if (text.empty()) return 0;
    const std::optional<double> value = parse_number(text);
    if (!value || !(*value >= 0 && *value < 1000))
      refuse(element, in_quotes(text) + " is no offset");
    return static_cast<std::size_t>(*value);
  }

  void end(std::string_view name) {
    if (name == "node" || name == "geometry" || name == "controller") inside_.pop_back();
    if (name == "p" && of_indices_) count_corners();
    of_indices_ = false;
  }

  /// Of the faces and lines of one list of indices.
  void count_corners() {
    const std::size_t n = words_ / std::max<std::size_t>(stride_, 1);
    const auto of_strip = [n](std::size_t each) { return n < each ? 0 : each * (n - each + 1); };
    const std::size_t corners = primitive_ == "tristrips" || primitive_ == "trifans" ? of_strip(3)
                                : primitive_ == "linestrips"                         ? of_strip(2)
                                                                                     : n;
    copies_.add_corners(inside_.back(), static_cast<double>(corners));
  }

  /// A node is placed where it stands; what lies in a library, where it is named.
  void open(const XmlElement& element) {
    const std::size_t object = copies_.add(0);
    if (element.name == "node") copies_.place(inside_.back(), object);
    const std::string_view id = element.attribute("id");
    if (!id.empty()) objects_.emplace(id, object);
    inside_.push_back(object);
  }

  void place(const XmlElement& element, std::string_view url) {
    if (url.empty() || url.front() != '#')
      throw InputError::at_line(
          file_, element.line,
          "the file names another file, " + in_quotes(url) + ", which is not read");
    placed_.push_back({inside_.back(), std::string(url.substr(1)), element.line});
  }

  void read_unit(const XmlElement& element) {
    const std::string_view metres = element.attribute("meter");
    if (metres.empty()) return;
    const std::optional<double> value = parse_number(metres);
    if (!value || !(*value > 0) || !std::isfinite(*value))
      throw InputError::at_line(file_, element.line, in_quotes(metres) + " is no unit in metres");
    shape_.metres = *value;
  }

  void add_text(std::string_view text) {
    if (!of_indices_) return;
    for (const char c : text) {
      const bool blank = c == ' ' || c == '\t' || c == '\n' || c == '\r';
      if (!blank && (c < '0' || c > '9'))
        throw InputError::in(file_, "an index that is no count: it holds " + in_quotes({&c, 1}));
      words_ += !blank && !in_word_;
      in_word_ = !blank;
    }
  }

  struct Placed {
    std::size_t parent;
    std::string id;
    std::size_t line;
  };
  const std::string& file_;
  DaeShape shape_;
  Copies copies_;
  std::vector<std::size_t> inside_;  ///< objects that are open; the first is the file
  std::map<std::string, std::size_t, std::less<>> objects_;
  std::vector<Placed> placed_;
  std::size_t skins_ = 0, others_ = 0;
  std::string primitive_;
  std::size_t stride_ = 0, words_ = 0;  ///< of the primitive; numbers in its list so far
  bool in_word_ = false;
  bool of_indices_ = false, is_collada_ = false, has_unit_ = false;
};

}  // namespace

DaeShape dae_shape(const std::string& file, std::string_view bytes, const Progress& progress) {
  return DaeWalk(file).read(bytes, progress);
}

}  // namespace sonde
