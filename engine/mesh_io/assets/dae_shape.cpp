// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/dae_shape.hpp"

#include <cmath>
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
    copies_.count(file_, inside_.front());
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
    of_indices_ = name == "p" || name == "ph" || name == "h";
  }

  void end(std::string_view name) {
    if (name == "node" || name == "geometry" || name == "controller") inside_.pop_back();
    of_indices_ = false;
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

  /// No more corners than this: a digit and a blank are one.
  void add_text(std::string_view text) {
    if (of_indices_) copies_.add_corners(inside_.back(), static_cast<double>(text.size() + 1) / 2);
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
  bool of_indices_ = false, is_collada_ = false, has_unit_ = false;
};

}  // namespace

DaeShape dae_shape(const std::string& file, std::string_view bytes, const Progress& progress) {
  return DaeWalk(file).read(bytes, progress);
}

}  // namespace sonde
