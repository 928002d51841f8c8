// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/comparison/analytic_wrench.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/base/error.hpp"
#include "engine/base/ordering.hpp"
#include "engine/body/body.hpp"
#include "engine/haptics/coupling/coupling_wrench.hpp"
#include "engine/study/comparison/half_space.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> kind_names = {"none", "ball", "half-space"};
constexpr int starts = 12;

/// Vertices on a sphere are not sufficient: those of a box are too. The faces must be near it as
/// well. No value if it is no ball, else AnalyticWrenches::facets.
std::optional<double> facets_of_ball(const Body& body) {
  if (!body.solid) return std::nullopt;
  const double radius = body.mass.radius;
  double facets = 0;
  for (const Triangle& t : body.soup.triangles) {
    const Vec3 a = body.soup.vertices[t[0]] - body.mass.com;
    const Vec3 b = body.soup.vertices[t[1]] - body.mass.com;
    const Vec3 c = body.soup.vertices[t[2]] - body.mass.com;
    const Vec3 normal = (b - a).cross(c - a).normalized();
    if (normal.dot(a) < 0.97 * radius) return std::nullopt;
    for (const Vec3& corner : {a, b, c})
      facets = std::max(facets, corner.cross(normal).norm() / radius);
  }
  return facets;
}

Wrench wrench_of(const RenderSetup& setup, const Pose& device, const Pose& separated) {
  const MassProperties& mass = setup.pair.probe().mass;
  if (in_object_norm(setup.coupling.mode))
    return object_norm_wrench(mass, device, separated, setup.coupling.k);
  return classic_wrench(separation_motion(mass, device, separated), Vec3::Zero(), Vec3::Zero(),
                        setup.coupling);
}

/// At most `most` of them, evenly chosen.
std::vector<std::size_t> thinned(const std::vector<std::size_t>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < most; ++i) out.push_back(all[i * all.size() / most]);
  return out;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  ordering::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

}  // namespace

AnalyticWrenches analytic_wrenches(const RenderSetup& setup, std::span<const TimedPose> path,
                                   std::uint64_t seed, std::size_t most_ticks, const Stop& stop) {
  const std::vector<Plane> faces = box_faces(setup.pair.fixed());
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (half_space_below(setup.pair.probe(), path[i].pose, faces)) known.push_back(i);
  if (known.empty()) {
    const auto facets = facets_of_ball(setup.pair.probe());
    return {facets ? AnalyticKind::ball : AnalyticKind::none, {}, facets.value_or(0)};
  }

  AnalyticWrenches out{.kind = AnalyticKind::half_space, .ticks = {}};
  for (const std::size_t i : thinned(known, most_ticks)) {
    if (stop && stop()) throw Cancelled();
    const Pose& device = path[i].pose;
    const Plane plane = *half_space_below(setup.pair.probe(), device, faces);
    const HalfSpaceSeparation s =
        half_space_separation(setup.pair.probe(), device, plane, seed, starts);
    const Wrench wrench = wrench_of(setup, device, s.separated);
    out.ticks.push_back({i, wrench.force, wrench.torque});
  }
  return out;
}

std::string to_json(const AnalyticWrenches& wrenches) {
  Json ticks = Json::array();
  for (const AnalyticTick& k : wrenches.ticks)
    ticks.push_back(
        {k.tick, k.force.x(), k.force.y(), k.force.z(), k.torque.x(), k.torque.y(), k.torque.z()});
  Json json{{"kind", kind_names[static_cast<std::size_t>(wrenches.kind)]},
            {"columns", {"tick", "fx", "fy", "fz", "tx", "ty", "tz"}},
            {"ticks", ticks}};
  if (wrenches.kind == AnalyticKind::ball) json["facets"] = wrenches.facets;
  return json.dump(1) + "\n";
}

AnalyticWrenches analytic_wrenches_of(const std::string& json, const std::string& source) {
  try {
    const Json whole = Json::parse(json);
    AnalyticWrenches out;
    const auto kind = std::ranges::find(kind_names, whole.at("kind").get<std::string>());
    if (kind == kind_names.end()) throw InputError::in(source, "has an unknown kind");
    out.kind = static_cast<AnalyticKind>(kind - kind_names.begin());
    out.facets = whole.value("facets", 0.0);
    for (const Json& tick : whole.at("ticks")) {
      const auto x = tick.get<std::array<double, 7>>();
      out.ticks.push_back({tick.at(0).get<std::size_t>(), {x[1], x[2], x[3]}, {x[4], x[5], x[6]}});
    }
    return out;
  } catch (const Json::exception& error) {
    throw InputError::in(source, std::string("holds no wrenches: ") + error.what());
  }
}

constexpr std::size_t ball_every = 50;  // ticks: neighbouring ticks are not independent trials

TorqueRealism torque_realism(const Rendering& rendering, const AnalyticWrenches& analytic,
                             double radius) {
  std::vector<double> force, torque;
  std::vector<TorqueRealism::AtTick> equal;
  if (analytic.kind == AnalyticKind::ball)
    for (std::size_t i = 0; i < rendering.size(); ++i) {
      const RenderedTick& tick = rendering[i];
      if (tick.force.isZero(0)) continue;
      torque.push_back(tick.torque.norm() / (radius * tick.force.norm()));
      if (i % ball_every == 0) equal.push_back({i, torque.back()});
    }
  for (const AnalyticTick& want : analytic.ticks) {
    const double size = want.force.norm();
    if (want.tick >= rendering.size() || rendering[want.tick].failed || !(size > 0)) continue;
    force.push_back((rendering[want.tick].force - want.force).norm() / size);
    const RenderedTick& is = rendering[want.tick];
    torque.push_back((is.torque - want.torque).norm() / (radius * size));
    if (const double own = is.force.norm(); own > 0)
      equal.push_back(
          {want.tick, (is.torque * (size / own) - want.torque).norm() / (radius * size)});
  }
  return {analytic.kind,  torque.size(),   median(force), largest(force),
          median(torque), largest(torque), equal,         analytic.facets};
}

}  // namespace sonde
