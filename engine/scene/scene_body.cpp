// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/scene/scene_body.hpp"

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/geometry/transform.hpp"
#include "engine/mending/repair_sentences.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/text/counted.hpp"
#include "engine/text/json_checks.hpp"

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

/// As short as that of a mesh alone is where it is shown: without the ending of the file.
std::string short_part_name(const SceneBody& part) {
  if (!part.name.empty()) return part.name;
  const std::string stem = part.mesh.stem().string();
  return part.component == 0 ? stem : stem + ":" + std::to_string(part.component);
}

/// "a, b and 3 more"; of one part, its own name.
std::string name_of_parts(const std::vector<SceneBody>& parts) {
  if (parts.size() == 1) return part_name(parts[0]);
  constexpr std::size_t most = 3;
  std::string name;
  for (std::size_t i = 0; i < std::min(parts.size(), most); ++i)
    name += (i == 0 ? "" : ", ") + short_part_name(parts[i]);
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
  std::vector<std::size_t> felt;
  for (std::size_t i = 0; i < whole.parts.size(); ++i)
    if (whole.parts[i].felt) felt.push_back(i);
  return join(whole, load_parts(whole, felt, unit, files, part_of(progress, 0, 0.6)),
              part_of(progress, 0.6, 1));
}

/// What is wrong with a part: where the scene's file names its mesh, or by the mesh where none
/// does.
InputError wrong(const SceneBody& whole, const SceneBody& part, const std::string& reason) {
  if (whole.scene_file.empty() || part.mesh_line == 0)
    return InputError::in(part.mesh.string(), reason);
  return InputError::at_line(whole.scene_file.string(), part.mesh_line,
                             part.mesh.filename().string() + ' ' + reason);
}

/// A part with the scale and repair of the body that it belongs to.
SceneBody part_in(const SceneBody& whole, SceneBody part) {
  part.scale *= whole.scale;
  part.pose.p *= whole.scale;
  if (whole.repair != Repair::automatic) part.repair = whole.repair;
  return part;
}

const std::vector<PolygonSoup>& components_of(const SceneBody& whole, const SceneBody& part,
                                              double unit, ComponentFiles& files,
                                              const Progress& progress) {
  const auto& components = files.of(part.mesh, mesh_scale(part, unit), progress);
  if (components.size() > most_parts)
    throw wrong(whole, part,
                "has " + std::to_string(components.size()) + " components; at most " +
                    std::to_string(most_parts) + " can be parts");
  return components;
}

/// @param part As it is in the body.
std::shared_ptr<const Body> load_component(const SceneBody& whole, const SceneBody& part,
                                           double unit, ComponentFiles& files,
                                           const Progress& progress) {
  const auto& components = components_of(whole, part, unit, files, part_of(progress, 0, 0.5));
  if (part.component > components.size())
    throw wrong(whole, part,
                "has " + counted(components.size(), "component") + ", not " +
                    std::to_string(part.component) + " as a part asks for");
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

void require_different_names(const SceneBody& whole) {
  std::set<std::string> names;
  for (const SceneBody& part : whole.parts)
    if (const std::string name = part_name(part); !names.insert(name).second)
      throw wrong(
          whole, part,
          "is a part named " + in_quotes(name) + " as another is: give each a \"name\" of its own");
}

/// What makes parts alike, wherever they stand.
auto kind_of(const SceneBody& whole, const SceneBody& asked) {
  const SceneBody part = part_in(whole, asked);
  return std::tuple(part.mesh.native(), part.component,
                    part.component == 0 ? std::string() : part_name(part), part.model, part.repair,
                    part.scale);
}

/// The first part of each kind of these, and for each of them which of those it is like.
struct Kinds {
  std::vector<std::size_t> first;
  std::vector<std::size_t> like;
};

Kinds kinds_of(const SceneBody& whole, const std::vector<std::size_t>& wanted) {
  Kinds kinds;
  std::map<decltype(kind_of(whole, whole)), std::size_t> known;
  for (const std::size_t i : wanted) {
    const auto [at, is_new] = known.emplace(kind_of(whole, whole.parts[i]), kinds.first.size());
    if (is_new) kinds.first.push_back(i);
    kinds.like.push_back(at->second);
  }
  return kinds;
}

/// The progress of steps that several threads do.
class SharedProgress {
 public:
  SharedProgress(const Progress& whole, std::size_t steps) : whole_(whole), done_(steps, 0.0) {}
  Progress of(std::size_t step) {
    return [this, step](double fraction) {
      const std::lock_guard lock(telling_);
      sum_ += fraction - std::exchange(done_[step], fraction);
      if (whole_ && !whole_(sum_ / static_cast<double>(done_.size()))) stopped_ = true;
      return !stopped_;
    };
  }

 private:
  const Progress& whole_;
  std::mutex telling_;
  std::vector<double> done_;
  double sum_ = 0;
  bool stopped_ = false;
};

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
    const std::size_t count =
        components_of(whole, part_in(whole, part), unit, files, progress).size();
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
    throw wrong(whole, parts.back(),
                "would be one of " + std::to_string(parts.size()) + " parts; at most " +
                    std::to_string(most_parts) + " can be");
  whole.parts = std::move(parts);
  require_different_names(whole);
  return whole;
}

BodyPart load_part(const SceneBody& whole, std::size_t i, double unit, ComponentFiles& files,
                   const Progress& progress) {
  const SceneBody part = part_in(whole, whole.parts[i]);
  auto body = part.component == 0 ? load(part, unit, progress)
                                  : load_component(whole, part, unit, files, progress);
  return {part_name(part), std::move(body), part.pose};
}

std::vector<BodyPart> load_parts(const SceneBody& whole, const std::vector<std::size_t>& wanted,
                                 double unit, ComponentFiles& files, const Progress& progress) {
  const Kinds kinds = kinds_of(whole, wanted);
  const std::size_t n = kinds.first.size();
  std::vector<std::shared_ptr<const Body>> bodies(n);
  std::vector<std::exception_ptr> failures(n);
  SharedProgress shared(progress, n);
  const auto load_kind = [&](std::size_t k) {
    try {
      bodies[k] = load_part(whole, kinds.first[k], unit, files, shared.of(k)).body;
    } catch (...) {
      failures[k] = std::current_exception();
      throw;
    }
  };
  try {
    run_parallel(n, std::max(1u, std::thread::hardware_concurrency()), load_kind);
  } catch (...) {
    // Those before the one that failed first were begun before it, and have come to their end.
    for (const std::exception_ptr& failure : failures)
      if (failure) std::rethrow_exception(failure);
    throw;
  }
  std::vector<BodyPart> out(whole.parts.size());
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    const SceneBody part = part_in(whole, whole.parts[wanted[j]]);
    out[wanted[j]] = {part_name(part), bodies[kinds.like[j]], part.pose};
  }
  return out;
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
      throw wrong(whole, part,
                  "is closed: as one of several parts it cannot be a surface, since its inside "
                  "counts");
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
    return with_offset(load_component(body, body, unit, files, progress), body.offset, {});
  }
  const Progress reading = body.offset == 0 ? progress : part_of(progress, 0, 0.5);
  return with_offset(
      load_body(body.mesh.string(), body.model, mesh_scale(body, unit), reading, body.repair),
      body.offset, part_of(progress, 0.5, 1));
}

}  // namespace sonde
