// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/assets/threemf_shape.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <map>

#include "engine/base/progress.hpp"
#include "engine/mesh_io/assets/copies.hpp"
#include "engine/mesh_io/assets/xml_walk.hpp"
#include "engine/mesh_io/assets/zip_file.hpp"
#include "engine/text/json_checks.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

struct ThreeMfUnit {
  std::string_view name;
  double metres;
};
constexpr std::array<ThreeMfUnit, 6> threemf_units{{{"micron", 1e-6},
                                                    {"millimeter", 1e-3},
                                                    {"centimeter", 1e-2},
                                                    {"inch", 0.0254},
                                                    {"foot", 0.3048},
                                                    {"meter", 1}}};
constexpr std::string_view model_type = "/3dmodel";

/// The part that the package says is the model.
std::string name_of_model(const std::string& file, const ZipFile& package) {
  const ZipFile::Part* relations = package.find("_rels/.rels");
  if (!relations) throw InputError::in(file, "not a 3MF file: it does not say where its model is");
  std::string target;
  walk_xml(file + ": _rels/.rels", package.unpack(*relations),
           {.begin =
                [&](const XmlElement& element) {
                  if (element.name == "Relationship" && target.empty() &&
                      element.attribute("Type").ends_with(model_type))
                    target = element.attribute("Target");
                }},
           {});
  if (target.starts_with('/')) target.erase(0, 1);
  return target;
}

class ModelWalk {
 public:
  explicit ModelWalk(std::string name) : name_(std::move(name)), build_(copies_.add(0)) {}

  ThreeMfShape read(std::string_view text, const Progress& progress) {
    walk_xml(name_, text, {.begin = [&](const XmlElement& element) { begin(element); }}, progress);
    for (const auto& [parent, id, line] : placed_) {
      const auto found = objects_.find(id);
      if (found == objects_.end())
        throw InputError::at_line(name_, line, "no object has the id " + in_quotes(id));
      copies_.place(parent, found->second);
    }
    shape_.triangles = static_cast<std::uint64_t>(copies_.count(name_, build_) / 3);
    return std::move(shape_);
  }

 private:
  void begin(const XmlElement& element) {
    if (element.name == "model") return begin_model(element);
    if (element.name == "object") {
      vertices_ = 0;
      current_ = copies_.add(0);
      objects_.emplace(element.attribute("id"), current_);
    } else if (element.name == "component") {
      place(element, current_);
    } else if (element.name == "item") {
      place(element, build_);
    } else if (element.name == "vertex") {
      for (const char* name : {"x", "y", "z"}) need_number(element, element.attribute(name));
      ++vertices_;
    } else if (element.name == "triangle") {
      for (const char* name : {"v1", "v2", "v3"}) need_vertex(element, element.attribute(name));
      copies_.add_corners(current_, 3);
    } else if (element.name == "beamlattice") {
      shape_.remarks.push_back("line " + std::to_string(element.line) +
                               ": a lattice of beams is not read");
    }
  }

  [[noreturn]] void refuse(const XmlElement& element, const std::string& why) const {
    throw InputError::at_line(name_, element.line, why);
  }
  void need_number(const XmlElement& element, std::string_view text) const {
    if (!parse_number(text)) refuse(element, in_quotes(text) + " is not a number");
  }
  /// The vertices of a mesh come before its triangles.
  void need_vertex(const XmlElement& element, std::string_view text) const {
    std::uint64_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size() || index >= vertices_)
      refuse(element,
             in_quotes(text) + " is none of the " + std::to_string(vertices_) + " vertices");
  }
  void check_transform(const XmlElement& element) const {
    std::string_view text = element.attribute("transform");
    if (text.empty()) return;
    int count = 0;
    constexpr std::string_view blanks = " \t\r\n";
    for (std::size_t at = 0; (at = text.find_first_not_of(blanks, at)) != text.npos; ++count) {
      const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
      need_number(element, text.substr(at, end - at));
      at = end;
    }
    if (count != 12)
      refuse(element, "a transform of " + std::to_string(count) + " numbers, not 12");
  }

  void begin_model(const XmlElement& element) {
    const std::string_view name = element.attribute("unit");
    for (const ThreeMfUnit& unit : threemf_units)
      if (unit.name == name) shape_.metres = unit.metres;
    if (!name.empty() &&
        std::ranges::find(threemf_units, name, &ThreeMfUnit::name) == threemf_units.end())
      throw InputError::at_line(name_, element.line, in_quotes(name) + " is no unit of 3MF");
    std::string_view needed = element.attribute("requiredextensions");
    while (!needed.empty()) {
      const std::string_view prefix = needed.substr(0, needed.find(' '));
      needed.remove_prefix(std::min(needed.size(), prefix.size() + 1));
      const std::string_view extension = element.attribute("xmlns:" + std::string(prefix));
      // Those of looks, and those that only name parts, which place() sees.
      if (prefix.empty() || extension.find("/material/") != extension.npos ||
          extension.find("/production/") != extension.npos)
        continue;
      throw InputError::at_line(
          name_, element.line,
          "the file requires the extension " + in_quotes(extension) + ", which is not read");
    }
  }

  void place(const XmlElement& element, std::size_t parent) {
    if (!element.attribute("path").empty())
      throw InputError::at_line(name_, element.line,
                                "an object in another part of the package, " +
                                    in_quotes(element.attribute("path")) +
                                    ", is not read: export it as one model");
    check_transform(element);
    placed_.push_back({parent, std::string(element.attribute("objectid")), element.line});
  }

  struct Placed {
    std::size_t parent;
    std::string id;
    std::size_t line;
  };
  std::string name_;
  ThreeMfShape shape_;
  Copies copies_;
  std::size_t build_, current_ = build_;
  std::uint64_t vertices_ = 0;  ///< of the mesh so far
  std::map<std::string, std::size_t, std::less<>> objects_;
  std::vector<Placed> placed_;
};

}  // namespace

ThreeMfShape threemf_shape(const std::string& file, std::string_view bytes,
                           const Progress& progress) {
  const ZipFile package(file, bytes);
  const std::string name = name_of_model(file, package);
  const ZipFile::Part* model = package.find(name);
  if (!model)
    throw InputError::in(file, "the package has no part " + in_quotes(name) + ", its model");
  const std::string text = package.unpack(*model);
  ThreeMfShape shape = ModelWalk(file + ": " + model->name).read(text, progress);
  const std::string types =
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/"
      "content-types\"/>";
  const std::string relations =
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Target=\"/3D/3dmodel.model\" Id=\"model\" Type=\"http://schemas.microsoft.com/"
      "3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
  shape.bytes = zip_of(
      {{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", text}});
  return shape;
}

}  // namespace sonde
