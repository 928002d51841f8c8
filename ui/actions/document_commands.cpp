// SPDX-License-Identifier: GPL-3.0-or-later
// The commands: each is one step of the document's history, and what that changes is shown.
#include <vtkPolyData.h>

#include <QApplication>
#include <QClipboard>
#include <algorithm>
#include <utility>

#include "engine/scene/write_scene.hpp"
#include "engine/settings/device_settings_file.hpp"
#include "engine/settings/settings.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/meshes_dialog.hpp"
#include "ui/actions/opener.hpp"
#include "ui/base/format.hpp"
#include "ui/document/kept_gains.hpp"
#include "ui/document/pose_text.hpp"
#include "ui/document/same_pose.hpp"

namespace sonde::ui {
namespace {

bool same(const std::optional<DeviceSettings>& a, const std::optional<DeviceSettings>& b) {
  return a.has_value() == b.has_value() &&
         (!a || device_settings_text(*a) == device_settings_text(*b));
}

SceneBody& body_of(Scene& scene, Role role) {
  return role == Role::probe ? scene.probe : scene.fixed;
}

bool is_suited(const Scene& scene, const Body& probe) {
  return ui::same(scene.coupling, suited_coupling(probe.mass));
}

/// Gains that suited the probe suit it again.
LoadedScene suited_again(LoadedScene opened, bool suited) {
  if (suited) opened.scene.coupling = opened.coupling = suited_coupling(opened.pair.probe().mass);
  return opened;
}

/// Bodies that something else owns too.
std::shared_ptr<const Body> shared(const std::shared_ptr<const Bodies>& bodies, Role role) {
  const Pair& pair = bodies->pair;
  return {bodies, role == Role::probe ? &pair.probe() : &pair.fixed()};
}

}  // namespace

Content DocumentControl::now() const {
  Content content = document_.content();
  content.here = here();
  return content;
}

Pose DocumentControl::here() const {
  // What is on show may still be the bodies of before an undo.
  const bool on_show = session_ && document_.content().bodies == on_show_;
  return on_show ? session_->device_pose() : document_.content().here;
}

void DocumentControl::place(const Pose& X_FM, const QString& what, bool mergeable) {
  if (document_.empty()) return;
  Content wanted = now();
  document_.set_here(wanted.here);
  wanted.here = {X_FM.q.normalized(), X_FM.p};
  document_.change(what, wanted, mergeable);
}

void DocumentControl::moved_from(const Pose& before, const QString& what, bool mergeable) {
  if (document_.empty()) return;
  document_.set_here(before);
  document_.change(what, now(), mergeable);
}

void DocumentControl::set_coupling(const Coupling& coupling) {
  if (document_.empty()) return;
  document_.set_coupling(coupling);
  emit changed();
}

void DocumentControl::set_device_settings(const DeviceSettings& settings) {
  if (document_.empty() || !document_.content().scene.device.settings)
    return emit device_settings_changed(settings);  // the device's own, kept with it
  Content wanted = now();
  wanted.scene.device.settings = settings;
  // What a device wants of the loop, a scene says for itself.
  if (settings.rate_hz) wanted.scene.servo.rate_hz = *settings.rate_hz;
  if (settings.passivity_control)
    wanted.scene.servo.passivity.control = *settings.passivity_control;
  document_.set_here(wanted.here);
  document_.change(QStringLiteral("Device settings"), wanted, true);
}

void DocumentControl::set_knob(const ServoSettings& servo) {
  if (document_.empty()) return;
  Content wanted = now();
  document_.set_here(wanted.here);
  wanted.scene.servo.budget.microseconds = servo.budget.microseconds;
  wanted.scene.servo.accuracy = servo.accuracy;
  document_.change(QStringLiteral("Time or accuracy"), wanted, true);
}

void DocumentControl::start_from_here() {
  if (document_.empty()) return;
  Content wanted = now();
  document_.set_here(wanted.here);
  wanted.scene.probe.pose = storable(wanted.scene.fixed.pose * wanted.here, wanted.scene.unit);
  document_.change(QStringLiteral("Start from here"), wanted);
}

void DocumentControl::copy_pose() {
  if (session_) QApplication::clipboard()->setText(QString::fromStdString(pose_text(here())));
}

void DocumentControl::copy_matrix() {
  if (session_) QApplication::clipboard()->setText(QString::fromStdString(matrix_text(here())));
}

void DocumentControl::paste_pose() {
  if (document_.empty()) return;
  try {
    place(pose_in(QApplication::clipboard()->text().toStdString()), QStringLiteral("Paste pose"));
  } catch (const std::invalid_argument& bad) {
    prompts_.report_error(QStringLiteral("The clipboard holds no pose: %1.").arg(bad.what()));
  }
}

void DocumentControl::swap_bodies() {
  if (document_.empty()) return;
  Content wanted = now();
  std::swap(wanted.scene.probe, wanted.scene.fixed);
  std::swap(wanted.scene.probe.offset, wanted.scene.fixed.offset);  // of whatever is the probe
  wanted.scene.trajectory.reset();                                  // it is the other's
  wanted.here = inverse(wanted.here);
  const auto bodies = wanted.bodies;
  change_bodies(
      QStringLiteral("Swap probe and fixed body"), wanted,
      [bodies, scene = wanted.scene](const Progress& progress) {
        if (scene.probe.offset != 0 || !scene.fixed.parts.empty() || scene.fixed.components)
          return open_scene(scene, progress);
        return open_scene(scene, {shared(bodies, Role::fixed), shared(bodies, Role::probe)}, {},
                          {bodies->marks.fixed, bodies->marks.probe});
      });
}

void DocumentControl::replace_body(Role role, const QString& file) {
  Content wanted = now();
  SceneBody& body = body_of(wanted.scene, role);
  body.mesh = file.toStdString();
  body.parts.clear();
  const QString what = role == Role::probe ? QStringLiteral("Replace the probe")
                                           : QStringLiteral("Replace the fixed body");
  change_bodies(what, wanted, [scene = wanted.scene](const Progress& progress) {
    return open_scene(scene, progress);
  });
}

void DocumentControl::ask_bodies() {
  if (document_.empty()) return;
  const Content before = now();
  const Scene& scene = before.scene;
  const Body &probe = before.bodies->pair.probe(), &fixed = before.bodies->pair.fixed();
  const auto sides = [](const Body& body, double factor) {
    Eigen::AlignedBox3d box;
    for (const Vec3& vertex : body.soup.vertices) box.extend(vertex);
    return Vec3((box.sizes().array() - 2 * body.offset.by) / factor);  // the mesh's
  };
  MeshPair pair;
  pair.probe_file = scene.probe.mesh;
  pair.fixed_file = scene.fixed.mesh;
  pair.probe_size = sides(probe, mesh_scale(scene.probe, scene.unit));
  pair.fixed_size = sides(fixed, mesh_scale(scene.fixed, scene.unit));
  pair.probe_edges = probe.topology;
  pair.fixed_edges = fixed.topology;
  const PairSetup old = setup_of(scene);
  const auto said = prompts_.ask_bodies(pair, old);
  if (!said) return;
  Content wanted = before;
  wanted.scene = with_setup(scene, old, *said);
  // As far from the fixed body, for its size, as it was.
  const double grown =
      mesh_scale(wanted.scene.fixed, wanted.scene.unit) / mesh_scale(scene.fixed, scene.unit);
  const Pose moved = relative_pose(scene);
  wanted.here.p *= grown;
  if (same(before.here, moved)) wanted.here = relative_pose(wanted.scene);
  const bool suited = is_suited(scene, probe);
  change_bodies(QStringLiteral("Units, axes and insides"), wanted,
                [scene = wanted.scene, suited](const Progress& progress) {
                  return suited_again(open_scene(scene, progress), suited);
                });
}

void DocumentControl::set_repair(Role role, Repair repair) {
  take_body(
      role,
      repair == Repair::none ? QStringLiteral("Take %1 as in the file") : QStringLiteral("Mend %1"),
      [repair](SceneBody& body) {
        body.repair = repair;
        if (repair == Repair::none && body.model == Model::solid) body.model = Model::automatic;
      });
}

void DocumentControl::make_solid(Role role) {
  take_body(role, QStringLiteral("Close %1"), [](SceneBody& body) {
    body.repair = Repair::automatic;
    body.model = Model::solid;
  });
}

/// Reads that one again; the other stays as it is. `what` has a place for its name.
void DocumentControl::take_body(Role role, const QString& what,
                                const std::function<void(SceneBody&)>& change) {
  if (document_.empty()) return;
  Content wanted = now();
  const auto bodies = wanted.bodies;
  const Body& before = role == Role::probe ? bodies->pair.probe() : bodies->pair.fixed();
  const bool suited = is_suited(wanted.scene, bodies->pair.probe());
  change(body_of(wanted.scene, role));
  change_bodies(what.arg(short_name(before)), wanted,
                [bodies, role, suited, wanted = wanted.scene](const Progress& progress) {
                  Scene scene = wanted;
                  const bool is_probe = role == Role::probe;
                  const SceneBody& from = is_probe ? scene.probe : scene.fixed;
                  MeshMarks marks = bodies->marks;
                  (is_probe ? marks.probe : marks.fixed) = mark_of(from);
                  FixedBody fixed{shared(bodies, Role::fixed), bodies->parts};
                  auto probe = shared(bodies, Role::probe);
                  if (is_probe)
                    probe = load(from, scene.unit, progress);
                  else
                    fixed = load_fixed(scene, {}, {}, progress);
                  return suited_again(open_scene(scene, Pair(probe, fixed.body), bodies->trajectory,
                                                 marks, fixed.parts),
                                      suited);
                });
}

/// The session is made first: a mesh that cannot be read is no step.
void DocumentControl::change_bodies(const QString& what, const Content& wanted,
                                    std::function<LoadedScene(const Progress&)> open) {
  document_.set_here(here());
  opener_.make(
      what,
      [open = std::move(open), here = wanted.here](const Progress& progress) {
        LoadedScene opened = open(progress);
        opened.here = here;
        return opened;
      },
      [this, what, wanted](DrawnSession drawn) {
        const LoadedScene& opened = drawn.session->loaded();
        Content content = wanted;
        content.scene = opened.scene;
        content.bodies = std::make_shared<const Bodies>(
            Bodies{opened.pair, opened.trajectory, opened.marks, opened.parts});
        ready_ = std::move(drawn);
        document_.change(what, content);
        ready_.reset();
      },
      {});
}

// ---- What a command changes, is done, undone or done again

void DocumentControl::apply(const Content& from, const Content& to) {
  if (to.bodies != on_show_) return show_bodies(to);
  if (std::exchange(showing_, false))
    opener_.abandon();  // of what was gone back from before it was on show
  if (!session_) return;
  if (!same(from.scene.coupling, to.scene.coupling)) emit coupling_changed(to.scene.coupling);
  if (!same(from.scene.device.settings, to.scene.device.settings) && to.scene.device.settings)
    emit device_settings_changed(*to.scene.device.settings);
  if (from.scene.servo.budget.microseconds != to.scene.servo.budget.microseconds ||
      from.scene.servo.accuracy != to.scene.servo.accuracy)
    session_->set_knob(to.scene.servo);
  if (const auto looks = looks_of(to.scene.fixed); looks != looks_of(from.scene.fixed))
    emit parts_changed(looks);
  session_->set_start(relative_pose(to.scene));
  if (!same(from.here, to.here) && !same(session_->device_pose(), to.here))
    emit place_wanted(to.here);
  emit changed();
}

void DocumentControl::show_bodies(const Content& wanted) {
  const auto show = [this](DrawnSession drawn, const std::shared_ptr<const Bodies>& bodies) {
    on_show_ = bodies;
    index_on_show_ = document_.stack().index();
    showing_ = false;
    emit show_wanted(drawn, true);
    // The session took its time: more may have been done or undone meanwhile.
    const Content& content = document_.content();
    if (!content.bodies->parts.empty()) emit parts_changed(looks_of(content.scene.fixed));
    session_->set_start(relative_pose(content.scene));
    if (!same(session_->device_pose(), content.here)) emit place_wanted(content.here);
    watch();
    emit changed();
  };
  if (ready_) return show(std::move(*ready_), wanted.bodies);
  // Of a step that was passed before it was on show: given up, it would turn the history back while
  // that goes on.
  if (std::exchange(showing_, false)) opener_.abandon();
  const auto given_up = [this] {
    showing_ = false;
    setup_failed_ = !opener_.is_busy();
    if (index_on_show_) document_.stack().setIndex(*index_on_show_);
  };
  opener_.make(
      QStringLiteral("Setting the bodies up again"),
      [wanted](const Progress&) {
        LoadedScene opened =
            open_scene(wanted.scene, wanted.bodies->pair, wanted.bodies->trajectory,
                       wanted.bodies->marks, wanted.bodies->parts);
        opened.here = wanted.here;
        return opened;
      },
      [show, bodies = wanted.bodies](DrawnSession drawn) { show(std::move(drawn), bodies); },
      given_up);
  showing_ = true;
}

void DocumentControl::note_index(int index) {
  // While a command is done or undone the index is still that of before.
  if (document_.empty()) return;
  if (document_.content().bodies == on_show_)
    index_on_show_ = index;
  else if (index_on_show_ && index <= *index_on_show_ && index == document_.stack().count())
    index_on_show_.reset();  // a change took the place of that step
}

/// Where the setting up of bodies is given up and no step has those on show any more, it is done
/// after all: the view must not show other bodies than the document has.
void DocumentControl::show_what_was_not(const QString& reason) {
  const bool failed = std::exchange(setup_failed_, false) && !reason.isEmpty();
  if (failed || index_on_show_ || showing_ || document_.empty()) return;
  emit say(QStringLiteral("The bodies are set up again: what was changed since needs them"));
  show_bodies(document_.content());
}

}  // namespace sonde::ui
