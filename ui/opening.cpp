// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/geometry/read_mesh.hpp"
#include "engine/scene/settings.hpp"
#include "ui/camera.hpp"
#include "ui/resources.hpp"

namespace sonde::ui {
namespace {

constexpr double depth_at_limit = 0.02;  // of the probe's radius
constexpr double start_gap = 0.05;       // of the probe's radius

/// The part of a job's progress from `from` to `to`.
Progress part(const Progress& progress, double from, double to) {
  if (!progress) return {};
  return [=](double fraction) { return progress(from + (to - from) * fraction); };
}

Vec3 size_of(const PolygonSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : soup.points) box.extend(point);
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
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

void scale(PolygonSoup& soup, double factor) {
  for (Vec3& point : soup.points) point *= factor;
}

std::optional<Vec3> vector_in(const QJsonObject& object, const char* key) {
  const QJsonArray array = object.value(QLatin1String(key)).toArray();
  if (array.size() != 3) return std::nullopt;
  return Vec3(array[0].toDouble(), array[1].toDouble(), array[2].toDouble());
}

/// camera_position, camera_target and camera_up of the scene's `view`: world frame, scene's unit.
/// A camera with no place to stand is none.
std::optional<CameraPlace> camera_of(const Scene& scene) {
  const QJsonObject view = QJsonDocument::fromJson(QByteArray::fromStdString(scene.view)).object();
  const auto position = vector_in(view, "camera_position");
  const auto target = vector_in(view, "camera_target");
  if (!position || !target) return std::nullopt;
  const Vec3 up = vector_in(view, "camera_up").value_or(Vec3::UnitZ());
  if (!((*position - *target).cross(up).norm() > 0)) return std::nullopt;
  const Pose X_FW = inverse(scene.fixed.pose);
  return CameraPlace{X_FW * Vec3(*position * scene.unit), X_FW * Vec3(*target * scene.unit),
                     X_FW.q * up};
}

}  // namespace

Opened open_scene(const std::filesystem::path& file, const Progress& progress) {
  const Scene scene = read_scene(file);
  std::vector<TimedPose> trajectory;
  std::optional<DeviceProfile> device;
  if (!scene.device.profile.empty())
    device = find_device_profile(scene.device.profile, device_profile_folders());
  if (scene.trajectory) trajectory = read_trajectory(*scene.trajectory);
  auto probe = load(scene.probe, scene.unit, part(progress, 0, 0.5));
  auto fixed = load(scene.fixed, scene.unit, part(progress, 0.5, 1));
  return {.pair = {std::move(probe), std::move(fixed)},
          .name = scene.name,
          .probe_file = scene.probe.mesh,
          .fixed_file = scene.fixed.mesh,
          .start = relative_pose(scene),
          .coupling = scene.coupling,
          .servo = scene.servo,
          .trajectory = std::move(trajectory),
          .device = std::move(device),
          .device_settings = scene.device.settings,
          .camera = camera_of(scene)};
}

MeshPair read_pair(const std::filesystem::path& probe, const std::filesystem::path& fixed,
                   const Progress& progress) {
  MeshPair pair;
  pair.probe_file = probe;
  pair.fixed_file = fixed;
  pair.probe = read_mesh(probe, 1, part(progress, 0, 0.5));
  pair.fixed = read_mesh(fixed, 1, part(progress, 0.5, 1));
  pair.probe_size = size_of(pair.probe);
  pair.fixed_size = size_of(pair.fixed);
  return pair;
}

const char* guess_unit(const MeshPair& pair) {
  const double side = std::max(pair.probe_size.maxCoeff(), pair.fixed_size.maxCoeff());
  if (side >= 20) return "mm";
  return side >= 2 ? "cm" : "m";
}

Opened build_pair(MeshPair pair, double unit, const Progress& progress) {
  scale(pair.probe, unit);
  scale(pair.fixed, unit);
  const auto build = [](const PolygonSoup& soup, const std::filesystem::path& file,
                        const Progress& report) {
    return make_body(soup, Model::automatic, file.stem().string(), report);
  };
  auto probe = build(pair.probe, pair.probe_file, part(progress, 0, 0.5));
  auto fixed = build(pair.fixed, pair.fixed_file, part(progress, 0.5, 1));
  const Coupling coupling = suited_coupling(probe->mass);
  const Pose start = beside(*probe, *fixed, start_direction());
  const std::string name = probe->name + " against " + fixed->name;
  return {.pair = {std::move(probe), std::move(fixed)},
          .name = name,
          .probe_file = pair.probe_file,
          .fixed_file = pair.fixed_file,
          .start = start,
          .coupling = coupling};
}

Coupling suited_coupling(const MassProperties& probe) {
  Coupling coupling;
  const double k = coupling.max_force / (depth_at_limit * std::max(probe.radius, 1e-9));
  set(coupling, "k", k);
  set(coupling, "k_t", k);
  // The classic spring that turns as stiffly as the object norm does: kÎ, over the mean axis.
  set(coupling, "k_r", k * probe.inertia.mean());
  return coupling;
}

Pose beside(const Body& probe, const Body& fixed, const Vec3& direction) {
  const Vec3 d = direction.normalized();
  const double gap = start_gap * probe.mass.radius;
  const double along = reach(fixed, d) + reach(probe, -d) + gap;
  // Sideways the centres of mass are in line.
  const Vec3 across = fixed.mass.com - probe.mass.com;
  return {Quat::Identity(), across - d * d.dot(across) + d * along};
}

}  // namespace sonde::ui
