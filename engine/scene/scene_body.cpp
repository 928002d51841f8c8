// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/scene_body.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/mending/repair_sentences.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/text/counted.hpp"

namespace sonde {

double mesh_scale(const SceneBody& body, double unit) {
  return has_own_unit(body.mesh) ? body.scale : unit * body.scale;
}

std::string part_name(const SceneBody& part) {
  if (!part.name.empty()) return part.name;
  const std::string file = part.mesh.filename().string();
  return part.component == 0 ? file : file + ":" + std::to_string(part.component);
}

std::vector<SceneBody> meshes_of(const SceneBody& body) {
  return body.parts.empty() ? std::vector{body} : body.parts;
}

namespace {

/// "a.off, b.off and 3 more".
std::string name_of_parts(const std::vector<SceneBody>& parts) {
  constexpr std::size_t most = 3;
  std::string name;
  for (std::size_t i = 0; i < std::min(parts.size(), most); ++i)
    name += (i == 0 ? "" : ", ") + part_name(parts[i]);
  if (parts.size() > most) name += " and " + std::to_string(parts.size() - most) + " more";
  return name;
}

void append(PolygonSoup& all, const Body& body, const Pose& X, const std::string& name) {
  const std::size_t first = all.points.size();
  const Transform place(X);
  for (const Vec3& x : body.soup.vertices) all.points.push_back(place * x);
  for (const Triangle& t : body.soup.triangles)
    all.polygons.push_back({first + t[0], first + t[1], first + t[2]});
  const std::string who = name + ": ";
  for (const std::vector<std::string>& said : {body.remarks, sentences(body.repairs)})
    for (const std::string& sentence : said)
      all.remarks.push_back(std::string(who).append(sentence));
}

std::shared_ptr<const Body> with_offset(std::shared_ptr<const Body> nominal, double offset,
                                        const Progress& progress) {
  if (offset == 0) return nominal;
  return offset_faces(*nominal, offset, progress);
}

std::shared_ptr<const Body> joined(const SceneBody& whole, double unit, ComponentFiles& files,
                                   const Progress& progress) {
  const auto felt = static_cast<double>(std::ranges::count(whole.parts, true, &SceneBody::felt));
  std::vector<BodyPart> parts(whole.parts.size());
  double done = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!whole.parts[i].felt) continue;
    parts[i] = load_part(whole, i, unit, files,
                         part_of(progress, 0.6 * done / felt, 0.6 * (done + 1) / felt));
    ++done;
  }
  return join(whole, parts, part_of(progress, 0.6, 1));
}

/// A part with the scale and repair of the body that it belongs to.
SceneBody part_in(const SceneBody& whole, SceneBody part) {
  part.scale *= whole.scale;
  part.pose.p *= whole.scale;
  if (whole.repair != Repair::automatic) part.repair = whole.repair;
  return part;
}

std::shared_ptr<const Body> load_component(const SceneBody& part, double unit,
                                           ComponentFiles& files, const Progress& progress) {
  const auto& components = files.of(part.mesh, mesh_scale(part, unit), part_of(progress, 0, 0.5));
  if (part.component > components.size())
    throw InputError::in(part.mesh.string(), "has " + counted(components.size(), "component") +
                                                 ", not " + std::to_string(part.component) +
                                                 " as a part asks for");
  return make_body(components[part.component - 1], part.model, part_name(part),
                   part_of(progress, 0.5, 1), part.repair);
}

/// A body of one mesh, converted to a body with a single part.
SceneBody as_whole(const SceneBody& body) {
  SceneBody whole = body, part = body;
  part.pose = Pose();
  part.offset = 0;
  part.scale = 1;
  whole.model = Model::automatic;
  whole.components = false;
  whole.parts = {part};
  return whole;
}

void require_different_names(const std::vector<SceneBody>& parts) {
  std::set<std::string> names;
  for (const SceneBody& part : parts)
    if (const std::string name = part_name(part); !names.insert(name).second)
      throw InputError::in(part.mesh.string(),
                           "two parts are named \"" + name + "\": give each a \"name\"");
}

}  // namespace

SceneBody with_components(const SceneBody& body, double unit, ComponentFiles& files,
                          const Progress& progress) {
  if (body.parts.empty() && !body.components) return body;
  SceneBody whole = body.parts.empty() ? as_whole(body) : body;
  if (std::ranges::none_of(whole.parts, &SceneBody::components)) return whole;
  std::vector<SceneBody> parts;
  for (SceneBody part : std::exchange(whole.parts, {})) {
    if (!part.components) {
      parts.push_back(part);
      continue;
    }
    const double scale = mesh_scale(part_in(whole, part), unit);
    const std::size_t count = files.of(part.mesh, scale, progress).size();
    part.components = false;
    if (count < 2) {
      parts.push_back(part);
      continue;
    }
    const std::string name = part.name;
    for (part.component = 1; part.component <= count; ++part.component) {
      if (!name.empty()) part.name = name + ":" + std::to_string(part.component);
      parts.push_back(part);
    }
  }
  if (parts.size() > most_parts)
    throw InputError::in(parts.back().mesh.string(),
                         "there would be " + std::to_string(parts.size()) + " parts; at most " +
                             std::to_string(most_parts) + " can be");
  whole.parts = std::move(parts);
  require_different_names(whole.parts);
  return whole;
}

BodyPart load_part(const SceneBody& whole, std::size_t i, double unit, ComponentFiles& files,
                   const Progress& progress) {
  const SceneBody part = part_in(whole, whole.parts[i]);
  auto body = part.component == 0 ? load(part, unit, progress)
                                  : load_component(part, unit, files, progress);
  return {part_name(part), std::move(body), part.pose};
}

std::shared_ptr<const Body> join(const SceneBody& whole, const std::vector<BodyPart>& parts,
                                 const Progress& progress) {
  PolygonSoup all;
  std::vector<BodyPart> felt;
  std::vector<SceneBody> named;
  for (std::size_t i = 0; i < whole.parts.size(); ++i) {
    const SceneBody& part = whole.parts[i];
    if (!part.felt) continue;
    if (part.model == Model::surface && parts[i].body->topology.closed)
      throw InputError::in(part.mesh.string(),
                           "is closed: as one of several parts it cannot be a "
                           "surface, since its inside counts");
    append(all, *parts[i].body, parts[i].X_BP, parts[i].name);
    felt.push_back(parts[i]);
    named.push_back(part);
  }
  if (felt.empty()) throw InputError("no part is felt");
  const Progress joining = whole.offset == 0 ? progress : part_of(progress, 0, 0.5);
  const auto body =
      make_body(all, Model::automatic, name_of_parts(named), joining, Repair::automatic);
  return with_offset(with_parts(*body, std::move(felt)), whole.offset, part_of(progress, 0.5, 1));
}

std::shared_ptr<const Body> load(const SceneBody& body, double unit, const Progress& progress) {
  if (!body.parts.empty() || body.components) {
    ComponentFiles files;
    const SceneBody whole = with_components(body, unit, files, part_of(progress, 0, 0.3));
    return joined(whole, unit, files, part_of(progress, 0.3, 1));
  }
  if (body.component != 0) {
    ComponentFiles files;
    return with_offset(load_component(body, unit, files, progress), body.offset, {});
  }
  const Progress reading = body.offset == 0 ? progress : part_of(progress, 0, 0.5);
  return with_offset(
      load_body(body.mesh.string(), body.model, mesh_scale(body, unit), reading, body.repair),
      body.offset, part_of(progress, 0.5, 1));
}

}  // namespace sonde
