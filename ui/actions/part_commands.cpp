// SPDX-License-Identifier: GPL-3.0-or-later
// The commands about the parts of the fixed body: each is one step of the document's history.
#include <vtkPolyData.h>

#include <QFileInfo>
#include <algorithm>
#include <set>

#include "engine/mesh_io/read_mesh.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/meshes_dialog.hpp"

namespace sonde::ui {
namespace {

/// The parts of a body; one of a single mesh is a part of its own, where it stands.
std::vector<SceneBody> as_parts(const SceneBody& body) {
  if (!body.parts.empty()) return body.parts;
  SceneBody only = body;
  only.pose = Pose();
  only.offset = 0;
  return {only};
}

/// A body of several parts where that one stands.
SceneBody of_parts(const SceneBody& body) {
  if (!body.parts.empty()) return body;
  SceneBody whole = body;
  whole.parts = as_parts(body);
  whole.scale = 1;
  whole.model = Model::automatic;
  whole.repair = Repair::automatic;
  whole.components = false;
  return whole;
}

/// A name for a new part that no other has.
std::string new_name(const std::vector<SceneBody>& parts, const SceneBody& part) {
  std::set<std::string> taken;
  for (const SceneBody& other : parts) taken.insert(part_name(other));
  const std::string wanted = part_name(part);
  std::string name = wanted;
  for (int k = 2; taken.contains(name); ++k) name = wanted + " (" + std::to_string(k) + ")";
  return name == wanted ? part.name : name;
}

/// The same triangles at the same places: nothing but what is seen differs.
bool feels_alike(const SceneBody& now, const SceneBody& before) {
  return std::ranges::equal(before.parts, now.parts, [](const SceneBody& x, const SceneBody& y) {
    return part_name(x) == part_name(y) && x.felt == y.felt && x.mesh == y.mesh && !y.components &&
           x.component == y.component;
  });
}

}  // namespace

void DocumentControl::change_parts(const QString& what,
                                   const std::function<void(SceneBody& fixed)>& change) {
  if (document_.empty()) return;
  Content wanted = now();
  SceneBody& fixed = wanted.scene.fixed;
  fixed = of_parts(fixed);
  change(fixed);
  fixed.mesh = fixed.parts.front().mesh;
  const Scene before = document_.content().scene;
  if (feels_alike(fixed, before.fixed)) {
    document_.set_here(wanted.here);
    return document_.change(what, wanted);
  }
  change_bodies(what, wanted,
                [before, bodies = wanted.bodies, changed = wanted.scene](const Progress& progress) {
                  Scene scene = changed;
                  FixedBody read = load_fixed(scene, before, bodies->parts, progress);
                  MeshMarks marks = bodies->marks;
                  marks.fixed = mark_of(scene.fixed);
                  const std::shared_ptr<const Body> probe(bodies, &bodies->pair.probe());
                  return open_scene(scene, Pair(probe, read.body), bodies->trajectory, marks,
                                    std::move(read.parts));
                });
}

void DocumentControl::add_parts(const QStringList& files) {
  if (files.isEmpty()) return;
  remember_folder_of(files[0]);
  const QString what = files.size() == 1
                           ? QStringLiteral("Add %1").arg(QFileInfo(files[0]).fileName())
                           : QStringLiteral("Add %1 parts").arg(files.size());
  change_parts(what, [&files](SceneBody& fixed) {
    // A file of the same origin as the first part's: in its unit, unless it states one.
    const SceneBody first = fixed.parts.front();
    for (const QString& file : files) {
      SceneBody part;
      part.mesh = file.toStdString();
      if (!has_own_unit(part.mesh) && !has_own_unit(first.mesh)) part.scale = first.scale;
      part.pose = first.pose;
      part.name = new_name(fixed.parts, part);
      fixed.parts.push_back(part);
    }
  });
}

void DocumentControl::remove_part(std::size_t part) {
  const auto parts = as_parts(document_.content().scene.fixed);
  if (document_.empty() || part >= parts.size()) return;
  if (parts.size() == 1)
    return emit say(QStringLiteral("The fixed body has no other part: there would be nothing."));
  if (parts[part].felt && std::ranges::count(parts, true, &SceneBody::felt) == 1)
    return emit say(QStringLiteral("No other part is felt: tick one of them first."));
  const QString name = QString::fromStdString(part_name(parts[part]));
  change_parts(QStringLiteral("Remove %1").arg(name), [part](SceneBody& fixed) {
    fixed.parts.erase(fixed.parts.begin() + static_cast<std::ptrdiff_t>(part));
  });
}

void DocumentControl::take_apart(std::size_t part) {
  const auto parts = as_parts(document_.content().scene.fixed);
  if (document_.empty() || part >= parts.size()) return;
  const QString name = QString::fromStdString(part_name(parts[part]));
  if (parts[part].component != 0 || components_in(part) < 2)
    return emit say(QStringLiteral("%1 hangs together: it is one component.").arg(name));
  change_parts(QStringLiteral("Take %1 apart").arg(name),
               [part](SceneBody& fixed) { fixed.parts[part].components = true; });
}

/// As many as show: bodies that are joined of others are told by their parts.
std::size_t DocumentControl::components_in(std::size_t part) const {
  const Bodies& bodies = *document_.content().bodies;
  const Body& body = bodies.parts.empty() ? bodies.pair.fixed() : *bodies.parts[part].body;
  return body.component_triangle.size();
}

void DocumentControl::rename_part(std::size_t part, const QString& name) {
  const auto parts = as_parts(document_.content().scene.fixed);
  const std::string wanted = name.trimmed().toStdString();
  if (document_.empty() || part >= parts.size() || wanted == part_name(parts[part])) return;
  const bool taken = std::ranges::any_of(
      parts, [&wanted](const SceneBody& other) { return part_name(other) == wanted; });
  if (wanted.empty() || taken) {
    emit say(taken ? QStringLiteral("There is a part named “%1” already.").arg(name)
                   : QStringLiteral("A part has a name."));
    return emit changed();
  }
  change_parts(QStringLiteral("Rename to %1").arg(name),
               [&](SceneBody& fixed) { fixed.parts[part].name = wanted; });
}

void DocumentControl::set_part_colour(std::size_t part, const QString& colour) {
  change_parts(QStringLiteral("Colour of a part"), [&](SceneBody& fixed) {
    if (part < fixed.parts.size()) fixed.parts[part].colour = colour.toStdString();
  });
}

void DocumentControl::set_part_shown(std::size_t part, bool shown) {
  change_parts(shown ? QStringLiteral("Show a part") : QStringLiteral("Hide a part"),
               [&](SceneBody& fixed) {
                 if (part < fixed.parts.size()) fixed.parts[part].shown = shown;
               });
}

void DocumentControl::set_part_felt(std::size_t part, bool felt) {
  const auto parts = as_parts(document_.content().scene.fixed);
  if (document_.empty() || part >= parts.size() || parts[part].felt == felt) return;
  if (!felt && std::ranges::count(parts, true, &SceneBody::felt) == 1) {
    emit say(QStringLiteral("At least one part is felt."));
    return emit changed();
  }
  change_parts(felt ? QStringLiteral("Feel a part") : QStringLiteral("Leave a part unfelt"),
               [&](SceneBody& fixed) { fixed.parts[part].felt = felt; });
}

}  // namespace sonde::ui
