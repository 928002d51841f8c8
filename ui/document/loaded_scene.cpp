// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/loaded_scene.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "engine/base/progress.hpp"
#include "engine/base/threads.hpp"
#include "engine/haptics/safety/borne_gains.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "engine/mesh_io/size_remark.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/scene/write_scene.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/number_text.hpp"
#include "ui/base/format.hpp"
#include "ui/base/resources.hpp"
#include "ui/document/kept_gains.hpp"
#include "ui/document/vector_in.hpp"
#include "ui/document/view_direction.hpp"

namespace sonde::ui {
namespace {

constexpr double depth_at_limit = 0.02;  // of the probe's radius
constexpr double start_gap = 0.05;       // of the probe's radius

Vec3 size_of(const PolygonSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : soup.points) box.extend(point);
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
}

Topology edges_of(const PolygonSoup& soup, const Progress& progress) {
  return analyse_topology(compacted(triangulate_all(soup), part_of(progress, 0, 0.5)),
                          part_of(progress, 0.5, 1));
}

/// Largest value of direction · x over the vertices of the body's triangles.
double reach(const Body& body, const Vec3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : body.soup.triangles)
    for (const auto index : triangle)
      most = std::max(most, direction.dot(body.soup.vertices[index]));
  return most;
}

/// On the side of the default camera, but to the right, so that neither body hides the other.
Vec3 start_direction() {
  const Vec3 towards = default_view_direction();
  const Vec3 right = Vec3::UnitZ().cross(towards).normalized();
  return towards + right;
}

/// Turns that axis of a mesh to z, the scene's up.
Quat turned_up(UpAxis up) {
  constexpr double quarter = std::numbers::pi / 2;
  if (up == UpAxis::x) return Quat(Eigen::AngleAxisd(-quarter, Vec3::UnitY()));
  if (up == UpAxis::y) return Quat(Eigen::AngleAxisd(quarter, Vec3::UnitX()));
  return Quat::Identity();
}

/// A factor such as 25.4 comes out of a division with a wrong last digit.
double rounded(double x) { return parse_number(number_text(x, 15)).value_or(x); }

/// The mesh's axis that is nearest to the scene's up.
UpAxis up_of(const Quat& q_WM) {
  const Vec3 up_M = q_WM.conjugate() * Vec3::UnitZ();
  Eigen::Index axis = 2;
  up_M.cwiseAbs().maxCoeff(&axis);
  return static_cast<UpAxis>(axis);
}

void scale(PolygonSoup& soup, double factor) {
  for (Vec3& point : soup.points) point *= factor;
}

/// camera_position, camera_target and camera_up of the scene's `view`: world frame, scene's unit.
/// Or its `direction`, towards the eye, and `up`: then the window chooses the target and how near.
/// A camera with no place to stand is none.
std::optional<CameraPlace> camera_of(const Scene& scene) {
  const QJsonObject view = QJsonDocument::fromJson(QByteArray::fromStdString(scene.view)).object();
  auto position = vector_in(view, "camera_position");
  auto target = vector_in(view, "camera_target");
  Vec3 up = vector_in(view, "camera_up").value_or(Vec3::UnitZ());
  if (const auto direction = vector_in(view, "direction"); direction && !position) {
    target = Vec3::Zero();
    position = direction;
    up = vector_in(view, "up").value_or(Vec3::UnitZ());
  }
  if (!position || !target) return std::nullopt;
  if (!((*position - *target).cross(up).norm() > 0)) return std::nullopt;
  const Pose X_FW = inverse(scene.fixed.pose);
  return CameraPlace{X_FW * Vec3(*position * scene.unit), X_FW * Vec3(*target * scene.unit),
                     X_FW.q * up};
}

/// The probe's scale in a scene whose unit is the fixed body's.
double probe_scale(const std::filesystem::path& file, const PairSetup& setup) {
  const double ratio = has_own_unit(file) ? 1 : setup.probe.unit / setup.fixed.unit;
  return rounded(setup.probe.scale * ratio);
}

}  // namespace

LoadedScene open_scene(const std::filesystem::path& file, const Progress& progress) {
  const Scene scene = read_scene(file);
  require_meshes(scene);
  require_trajectory(scene);
  return open_scene(scene, progress);
}

LoadedScene open_scene(const Scene& asked, const Progress& progress) {
  Scene scene = asked;
  std::vector<TimedPose> trajectory;
  if (!scene.device.profile.empty())
    find_device_profile(scene.device.profile, device_profile_folders());  // before the long work
  if (scene.trajectory) trajectory = read_trajectory(*scene.trajectory);
  const MeshMarks marks = marks_of(scene);
  std::shared_ptr<const Body> probe;
  FixedBody fixed;
  run_both(
      true, progress, [&](const Progress& half) { probe = load(scene.probe, scene.unit, half); },
      [&](const Progress& half) { fixed = load_fixed(scene, {}, {}, half); });
  return open_scene(scene, {std::move(probe), std::move(fixed.body)}, std::move(trajectory), marks,
                    std::move(fixed.parts));
}

FixedBody load_fixed(Scene& scene, const Scene& before, const std::vector<BodyPart>& known,
                     const Progress& progress) {
  ComponentFiles files;
  scene.fixed = with_components(scene.fixed, scene.unit, files, part_of(progress, 0, 0.2));
  const SceneBody& whole = scene.fixed;
  if (whole.parts.empty()) return {load(whole, scene.unit, part_of(progress, 0.2, 1)), {}};
  const bool same_whole = scene.unit == before.unit && whole.scale == before.fixed.scale &&
                          whole.repair == before.fixed.repair &&
                          known.size() == before.fixed.parts.size();
  const auto kind = [](const SceneBody& part) {
    return std::tuple(part.mesh.native(), part.component, part.scale, part.model, part.repair);
  };
  std::map<decltype(kind(whole)), std::size_t> old;
  for (std::size_t i = 0; same_whole && i < known.size(); ++i)
    old.emplace(kind(before.fixed.parts[i]), i);
  std::vector<std::size_t> wanted;
  std::vector<std::optional<std::size_t>> kept(whole.parts.size());
  for (std::size_t i = 0; i < whole.parts.size(); ++i)
    if (const auto at = old.find(kind(whole.parts[i])); at != old.end())
      kept[i] = at->second;
    else
      wanted.push_back(i);
  FixedBody out;
  out.parts = load_parts(whole, wanted, scene.unit, files, part_of(progress, 0.2, 0.6));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    const SceneBody& part = whole.parts[i];
    const Pose X_BP{part.pose.q, whole.scale * part.pose.p};
    out.parts[i] = {part_name(part), known[*kept[i]].body, X_BP};
  }
  out.body = join(whole, out.parts, part_of(progress, 0.6, 1));
  return out;
}

LoadedScene open_scene(const Scene& scene, const Pair& pair, std::vector<TimedPose> trajectory,
                       const MeshMarks& marks, std::vector<BodyPart> parts) {
  std::optional<DeviceProfile> device;
  if (!scene.device.profile.empty())
    device = find_device_profile(scene.device.profile, device_profile_folders());
  return {.pair = pair,
          .scene = scene,
          .name = scene.name,
          .probe_file = scene.probe.mesh,
          .fixed_file = scene.fixed.mesh,
          .marks = marks,
          .start = relative_pose(scene),
          .coupling = scene.coupling,
          .servo = scene.servo,
          .trajectory = std::move(trajectory),
          .device = std::move(device),
          .device_settings = scene.device.settings,
          .camera = camera_of(scene),
          .parts = std::move(parts)};
}

MeshPair read_pair(const std::filesystem::path& probe, const std::filesystem::path& fixed,
                   const Progress& progress) {
  MeshPair pair;
  pair.probe_file = probe;
  pair.fixed_file = fixed;
  pair.marks = {mark_of(probe), mark_of(fixed)};
  run_both(
      true, progress,
      [&](const Progress& half) {
        pair.probe = read_mesh(probe, 1, part_of(half, 0, 0.5));
        pair.probe_size = size_of(pair.probe);
        pair.probe_edges = edges_of(pair.probe, part_of(half, 0.5, 1));
      },
      [&](const Progress& half) {
        pair.fixed = read_mesh(fixed, 1, part_of(half, 0, 0.5));
        pair.fixed_size = size_of(pair.fixed);
        pair.fixed_edges = edges_of(pair.fixed, part_of(half, 0.5, 1));
      });
  return pair;
}

const char* guess_unit(const MeshPair& pair) {
  const double probe = has_own_unit(pair.probe_file) ? 0 : pair.probe_size.maxCoeff();
  const double fixed = has_own_unit(pair.fixed_file) ? 0 : pair.fixed_size.maxCoeff();
  const double side = std::max(probe, fixed);
  if (side >= hardly_metres) return "mm";
  return side >= 2 ? "cm" : "m";
}

PairSetup same_unit(const MeshPair& pair, double metres) {
  PairSetup setup;
  setup.probe.unit = has_own_unit(pair.probe_file) ? 1 : metres;
  setup.fixed.unit = has_own_unit(pair.fixed_file) ? 1 : metres;
  return setup;
}

PairSetup guess_setup(const MeshPair& pair) {
  return same_unit(pair, unit_in_metres(guess_unit(pair)).value_or(1));
}

double same_size_scale(const MeshPair& pair, const PairSetup& setup) {
  const double fixed = pair.fixed_size.maxCoeff() * setup.fixed.unit * setup.fixed.scale;
  const double probe = pair.probe_size.maxCoeff() * setup.probe.unit;
  return probe > 0 ? fixed / probe : 1;
}

Scene scene_of(const MeshPair& pair, const PairSetup& setup) {
  Scene scene;
  scene.unit = setup.fixed.unit;
  scene.probe = {.mesh = pair.probe_file,
                 .model = setup.probe.model,
                 .repair = setup.probe.repair,
                 .scale = probe_scale(pair.probe_file, setup),
                 .pose = {turned_up(setup.probe.up), Vec3::Zero()},
                 .offset = setup.probe.offset};
  scene.fixed = {.mesh = pair.fixed_file,
                 .model = setup.fixed.model,
                 .repair = setup.fixed.repair,
                 .scale = rounded(setup.fixed.scale),
                 .pose = {turned_up(setup.fixed.up), Vec3::Zero()}};
  scene.name = pair.probe_file.stem().string() + " against " + pair.fixed_file.stem().string();
  return scene;
}

PairSetup setup_of(const Scene& scene) {
  const auto body = [&scene](const SceneBody& from) {
    const double unit = has_own_unit(from.mesh) ? 1 : scene.unit;
    return BodySetup{unit, from.scale, up_of(from.pose.q), from.model, from.repair, from.offset};
  };
  return {body(scene.probe), body(scene.fixed)};
}

Scene with_setup(const Scene& scene, const PairSetup& old, const PairSetup& now) {
  Scene changed = scene;
  changed.unit = now.fixed.unit;
  changed.fixed.scale = now.fixed.scale;
  changed.probe.scale = probe_scale(scene.probe.mesh, now);
  changed.fixed.model = now.fixed.model;
  changed.probe.model = now.probe.model;
  changed.fixed.repair = now.fixed.repair;
  changed.probe.repair = now.probe.repair;
  changed.probe.offset = now.probe.offset;
  const double grown =
      mesh_scale(changed.fixed, changed.unit) / mesh_scale(scene.fixed, scene.unit);
  const auto moved = [&](const Pose& pose, UpAxis before, UpAxis after) {
    if (before == after && grown == 1) return pose;
    const Quat turn = turned_up(before).conjugate() * turned_up(after);
    const Pose placed{before == after ? pose.q : Quat(pose.q * turn), pose.p * grown};
    return storable(placed, changed.unit);
  };
  changed.probe.pose = moved(scene.probe.pose, old.probe.up, now.probe.up);
  changed.fixed.pose = moved(scene.fixed.pose, old.fixed.up, now.fixed.up);
  return changed;
}

LoadedScene build_pair(MeshPair pair, const PairSetup& setup, const Progress& progress) {
  Scene scene = scene_of(pair, setup);
  // The polygons of each body go as soon as it is built: they take more than the body does.
  const auto build = [&scene](PolygonSoup& soup, const SceneBody& body, const Progress& report) {
    scale(soup, mesh_scale(body, scene.unit));
    auto built = make_body(soup, body.model, body.mesh.stem().string(), report, body.repair);
    soup = {};
    return body.offset == 0 ? built : offset_faces(*built, body.offset);
  };
  std::shared_ptr<const Body> probe, fixed;
  run_both(
      true, progress, [&](const Progress& half) { probe = build(pair.probe, scene.probe, half); },
      [&](const Progress& half) { fixed = build(pair.fixed, scene.fixed, half); });
  scene.coupling = suited_coupling(probe->mass);
  const Quat q_FW = scene.fixed.pose.q.conjugate();
  const Pose start = beside(*probe, *fixed, q_FW * start_direction(), q_FW * scene.probe.pose.q);
  scene.probe.pose = storable(scene.fixed.pose * start, scene.unit);
  return open_scene(scene, {std::move(probe), std::move(fixed)}, {}, pair.marks);
}

namespace {

double stiffness_at_limit(const MassProperties& probe) {
  return Coupling().max_force / (depth_at_limit * std::max(probe.radius, 1e-9));
}

/// What a device takes by its profile; of rotations only where it has motors for torque. What it
/// does not say does not count.
BorneGains allowed_by(const DeviceProfile& device) {
  BorneGains most{.translation = device.max_stiffness.value};
  if (device.max_torque.value > 0) most.rotation = device.max_rotational_stiffness.value;
  return most;
}

Coupling of_stiffness(double k, const MassProperties& probe) {
  Coupling coupling;
  set(coupling, "k", k);
  set(coupling, "k_t", k);
  // The classic spring that turns as stiffly as the object norm does: kÎ, over the mean axis.
  set(coupling, "k_r", k * probe.inertia.mean());
  return coupling;
}

}  // namespace

Coupling suited_coupling(const MassProperties& probe, const DeviceProfile* device) {
  const double k = stiffness_at_limit(probe);
  const Coupling suited = of_stiffness(k, probe);
  if (!device) return suited;
  const double borne_k = borne(suited, allowed_by(*device), probe).k;
  return borne_k < suited.k ? of_stiffness(borne_k, probe) : suited;
}

namespace {

bool is_more_than_allowed(const Coupling& gains, const MassProperties& probe,
                          const DeviceProfile& device) {
  return is_reduced(borne(gains, allowed_by(device), probe), gains);
}

std::string origin_of_suited(const MassProperties& probe,
                             const std::optional<DeviceProfile>& device) {
  if (device && is_more_than_allowed(suited_coupling(probe), probe, *device))
    return "Stiffness: as much as " + device->name + " allows.";
  return "Stiffness: the force limit is reached " + number_text(100 * depth_at_limit, 3) +
         " % of the probe's radius deep" +
         (device ? ", which " + device->name + " allows." : std::string("."));
}

}  // namespace

std::string origin_of_gains(const Coupling& gains, bool of_file, const MassProperties& probe,
                            const std::optional<DeviceProfile>& device) {
  const Coupling suited = suited_coupling(probe, device ? &*device : nullptr);
  std::string words;
  if (of_file)
    words = "As opened: as the scene's file has them.";
  else if (same(gains, suited))
    return origin_of_suited(probe, device);
  else
    words = "As opened: k = " + round_figure(suited.k).toStdString() + " N/m.";
  if (device && is_more_than_allowed(gains, probe, *device))
    words += " The gains set are more than " + device->name +
             " allows; it renders as much as it allows.";
  return words;
}

Pose beside(const Body& probe, const Body& fixed, const Vec3& direction, const Quat& q_FM) {
  const Vec3 d = direction.normalized();
  const double gap = start_gap * probe.mass.radius;
  const double along = reach(fixed, d) + reach(probe, q_FM.conjugate() * Vec3(-d)) + gap;
  // Sideways the centres of mass are in line.
  const Vec3 across = fixed.mass.com - q_FM * probe.mass.com;
  return {q_FM, across - d * d.dot(across) + d * along};
}

}  // namespace sonde::ui
