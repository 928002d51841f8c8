// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_report.hpp"

#include <nlohmann/json.hpp>
#include <optional>

#include "engine/mending/repair_sentences.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/penetration/search/clearance_of.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/penetration/search/trivial_separation.hpp"
#include "engine/text/length_text.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

using Json = nlohmann::ordered_json;

struct Bounds {
  Vec3 low = Vec3::Zero();
  Vec3 high = Vec3::Zero();
};

/// Of the triangles: a file may hold vertices that none of them uses.
Bounds bounds_of(const Soup& soup) {
  Bounds bounds{soup.vertices[soup.triangles[0][0]], soup.vertices[soup.triangles[0][0]]};
  for (const Triangle& triangle : soup.triangles)
    for (const std::uint32_t corner : triangle) {
      bounds.low = bounds.low.cwiseMin(soup.vertices[corner]);
      bounds.high = bounds.high.cwiseMax(soup.vertices[corner]);
    }
  return bounds;
}

/// A rounded zero has no sign.
std::string text_of(double value) { return number_text(value + 0.0, 6); }

std::string text_of(const Vec3& v) {
  std::string text;
  for (const double x : v) text.append(text.empty() ? "(" : ", ").append(text_of(x));
  return text.append(")");
}

struct Defect {
  const char* name;
  const char* json_key;
  std::size_t count;
};

std::vector<Defect> defects_of(const Body& body) {
  const Topology& t = body.topology;
  return {{"triangles without area, set aside", "degenerate_triangles", body.degenerate},
          {"duplicate triangles", "duplicate_triangles", t.duplicate_triangles},
          {"open edges", "open_edges", t.open_edges},
          {"edges of three triangles or more", "nonmanifold_edges", t.nonmanifold_edges},
          {"edges with sides turned differently", "misoriented_edges", t.misoriented_edges}};
}

std::string defects_text(const Body& body) {
  std::string text;
  const auto add = [&](const std::string& defect) {
    text.append(text.empty() ? "" : "\n                  ").append(defect);
  };
  for (const Defect& defect : defects_of(body))
    if (defect.count > 0) add(std::to_string(defect.count) + " " + defect.name);
  return text.empty() ? "none" : text;
}

/// Each on a line of its own.
std::string listed(const std::vector<std::string>& sentences) {
  std::string text;
  for (const std::string& sentence : sentences)
    text.append(text.empty() ? "" : "\n                  ").append(printable(sentence));
  return text;
}

Json json_of(const Repairs& r) {
  return {{"joined_corners", r.joined},
          {"joined_within", r.reach},
          {"corners_on_edges", r.on_edges},
          {"unsearched_open_edges", r.unsearched},
          {"repeated_triangles", r.repeated},
          {"turned_triangles", r.turned_triangles},
          {"turned_parts", r.turned_parts},
          {"caps", r.caps},
          {"cap_triangles", r.cap_triangles},
          {"cap_area", r.cap_area},
          {"widest_cap", r.widest_cap},
          {"hidden_triangles", r.hidden},
          {"parts", r.parts},
          {"solid_parts", r.solid_parts},
          {"one_sided_parts", r.torn_parts},
          {"overlaps", r.overlaps},
          {"overlap_error", r.overlap_error},
          {"overlap_unknown", r.overlap_unknown},
          {"widest_mouth", r.widest_mouth}};
}

std::string offset_text(const FaceOffset& offset) {
  std::string text = offset_words(offset) + "; its mass is the mesh's; furthest corner " +
                     length_text(offset.furthest);
  if (offset.vanished > 0) text += ", " + std::to_string(offset.vanished) + " triangles vanished";
  return text;
}

std::string memory_text(const Body& body) {
  const auto taken = static_cast<double>(bytes(body));
  const auto triangles = static_cast<double>(body.soup.triangles.size());
  return number_text(1e-6 * taken, 4) + " MB (" + number_text(taken / triangles, 4) +
         " bytes a triangle)";
}

std::string text_of(const MeshReport& report) {
  const Body& body = report.body;
  const MassProperties& mass = body.mass;
  const Bounds bounds = bounds_of(body.soup);
  const auto line = [](std::string name, std::size_t letters, const std::string& value) {
    return "  " + name.append(16 - letters, ' ') + value + '\n';
  };
  const auto plain = [&](const std::string& name, const std::string& value) {
    return line(name, name.size(), value);
  };
  const auto axis = [&](int i) { return text_of(Vec3(mass.R_MP.col(i))); };

  std::string text = printable(report.file) + '\n';
  text += plain("triangles", std::to_string(body.soup.triangles.size()));
  if (const std::size_t touched = surface(body).triangles.size();
      touched != body.soup.triangles.size())
    text += plain("touched by", std::to_string(touched) + " triangles, where flat parts are one");
  text += plain("vertices", std::to_string(body.soup.vertices.size()));
  text += plain("components", std::to_string(body.component_triangle.size()));
  text += plain("model", std::string(body.solid ? "solid" : "surface") + " (" + body.why + ")");
  text += mass.by_volume ? plain("volume V", text_of(mass.measure) + " m³")
                         : plain("area A", text_of(mass.measure) + " m²");
  if (!body.mass_why.empty()) text += plain("mass", body.mass_why);
  text += plain("centre of mass", text_of(mass.com) + " m");
  const std::string inertia = mass.by_volume ? "inertia Î = I/V" : "inertia Î = I/A";
  text += line(inertia, 15, text_of(mass.inertia) + " m²");  // Î is two bytes, one letter
  text += plain("principal axes", axis(0) + " " + axis(1) + " " + axis(2));
  text += plain("radius R", text_of(mass.radius) + " m");
  text += plain("bounds", text_of(bounds.low) + " to " + text_of(bounds.high) + " m");
  text += plain("size", text_of(Vec3(bounds.high - bounds.low)) + " m");
  if (body.offset.by != 0) text += plain("offset", offset_text(body.offset));
  text += plain("memory", memory_text(body));
  text += plain("defects", defects_text(body));
  if (const std::string repairs = listed(sentences(body.repairs)); !repairs.empty())
    text += plain("mended", repairs);
  if (!body.remarks.empty()) text += plain("remarks", listed(body.remarks));
  return text;
}

Json json_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Json json_of(const MeshReport& report) {
  const Body& body = report.body;
  const MassProperties& mass = body.mass;
  const Bounds bounds = bounds_of(body.soup);
  Json json;
  json["file"] = utf8_text(report.file);
  json["triangles"] = body.soup.triangles.size();
  json["surface_triangles"] = surface(body).triangles.size();
  json["vertices"] = body.soup.vertices.size();
  json["components"] = body.component_triangle.size();
  json["model"] = body.solid ? "solid" : "surface";
  json["why"] = body.why;
  json[mass.by_volume ? "volume" : "area"] = mass.measure;
  if (!body.mass_why.empty()) json["mass_why"] = body.mass_why;
  json["center_of_mass"] = json_of(mass.com);
  json["inertia"] = json_of(mass.inertia);
  for (int i = 0; i < 3; ++i) json["principal_axes"].push_back(json_of(Vec3(mass.R_MP.col(i))));
  json["radius"] = mass.radius;
  json["bounds"] = {{"low", json_of(bounds.low)}, {"high", json_of(bounds.high)}};
  if (body.offset.by != 0)
    json["offset"] = {{"by", body.offset.by},
                      {"furthest", body.offset.furthest},
                      {"held_back", body.offset.held_back},
                      {"least", body.offset.least},
                      {"vanished", body.offset.vanished},
                      {"folded", body.offset.folded},
                      {"filled", body.offset.filled}};
  json["memory_bytes"] = bytes(body);
  for (const Defect& defect : defects_of(body)) json["defects"][defect.json_key] = defect.count;
  json["defects"]["turned"] = body.turned;
  json["repairs"] = json_of(body.repairs);
  json["remarks"] = body.remarks;
  return json;
}

std::string text_of(const Between& between) {
  if (!between.clearance.overlapping)
    return "apart           " + number_text(between.clearance.distance, 6) + " m";
  const std::string all = "they touch or overlap";
  return between.depth ? all + ": " + number_text(*between.depth, 6) + " m deep" : all;
}

}  // namespace

std::optional<Between> between(const std::shared_ptr<const Body>& first,
                               const std::shared_ptr<const Body>& second,
                               const Progress& progress) {
  const auto apart = trivial_separation(*first, *second, Pose());
  if (apart && apart->status == Status::failed) return std::nullopt;
  Between out{clearance_of(*first, *second, Pose(), !apart), std::nullopt};
  if (apart) return out;
  StaticOptions options;
  options.want_lower_bound = false;
  const Separation deep = separate_static(Pair(first, second), Pose(), options, progress);
  if (deep.status != Status::failed) out.depth = deep.depth;
  return out;
}

std::string to_text(const std::vector<MeshReport>& reports, const std::optional<Between>& between) {
  std::string text;
  for (const MeshReport& report : reports)
    text.append(text.empty() ? "" : "\n").append(text_of(report));
  if (between) text += "\nas they lie in their files\n  " + text_of(*between) + "\n";
  return text;
}

std::string to_json(const std::vector<MeshReport>& reports, const std::optional<Between>& between) {
  Json json;
  json["format"] = 1;
  json["units"] = {{"volume", "m^3"}, {"area", "m^2"}, {"center_of_mass", "m"}, {"inertia", "m^2"},
                   {"radius", "m"},   {"bounds", "m"}, {"offset", "m"}};
  json["meshes"] = Json::array();
  for (const MeshReport& report : reports) json["meshes"].push_back(json_of(report));
  if (between) {
    const Clearance& room = between->clearance;
    const auto point = [](const Vec3& x) { return Json{x.x(), x.y(), x.z()}; };
    json["units"]["clearance"] = "m";
    json["clearance"] = {{"distance", room.distance},
                         {"overlapping", room.overlapping},
                         {"on_first", point(room.on_probe)},
                         {"on_second", point(room.on_fixed)}};
    // One continuous number: less than 0, by the depth, where they overlap.
    if (!room.overlapping)
      json["clearance"]["signed_distance"] = room.distance;
    else if (between->depth)
      json["clearance"]["signed_distance"] = 0 - *between->depth;  // no -0
  }
  // A file's name may be no UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace sonde::app
