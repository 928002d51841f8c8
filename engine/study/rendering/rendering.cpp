// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/rendering/rendering.hpp"

#include <array>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/chart.hpp"
#include "engine/haptics/loop/haptic_loop.hpp"
#include "engine/study/rendering/contact_torque.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

RenderedTick tick_of(const HapticLoop& loop, double t, double moved) {
  const Separation& s = loop.separation();
  RenderedTick out;
  out.t = t;
  out.moved = moved;
  out.failed = s.status == Status::failed;
  out.jumped = s.fell();
  out.separated = s.separated;
  if (out.failed) return out;
  out.force = loop.wrench().force;
  out.torque = loop.wrench().torque;
  out.depth = s.depth;
  out.contacts = s.clusters.size;
  out.converged = s.status == Status::separated || s.converged;
  return out;
}

/// The numbers of a tick in the order of its row.
constexpr std::size_t width = 20;
using Row = std::array<double, width>;

Row row_of(const RenderedTick& k) {
  const Quat& q = k.separated.q;
  const Vec3& p = k.separated.p;
  return {k.t,
          k.moved,
          k.force.x(),
          k.force.y(),
          k.force.z(),
          k.torque.x(),
          k.torque.y(),
          k.torque.z(),
          k.depth,
          static_cast<double>(k.contacts),
          k.jumped ? 1.0 : 0.0,
          k.failed ? 1.0 : 0.0,
          k.converged ? 1.0 : 0.0,
          p.x(),
          p.y(),
          p.z(),
          q.w(),
          q.x(),
          q.y(),
          q.z()};
}

RenderedTick tick_of(const Row& row) {
  RenderedTick out;
  out.t = row[0];
  out.moved = row[1];
  out.force = {row[2], row[3], row[4]};
  out.torque = {row[5], row[6], row[7]};
  out.depth = row[8];
  out.contacts = static_cast<int>(row[9]);
  out.jumped = row[10] != 0;
  out.failed = row[11] != 0;
  out.converged = row[12] != 0;
  out.separated.p = {row[13], row[14], row[15]};
  out.separated.q = Quat(row[16], row[17], row[18], row[19]);
  return out;
}

constexpr std::array<const char*, width> names = {
    "t",      "moved",  "fx",        "fy", "fz", "tx", "ty",  "tz",  "depth", "contacts",
    "jumped", "failed", "converged", "sx", "sy", "sz", "sqw", "sqx", "sqy",   "sqz"};

}  // namespace

double stiffness_of(const Coupling& coupling) {
  return in_object_norm(coupling.mode) ? coupling.k : coupling.k_t;
}

Rendering render(const RenderSetup& setup, Method method, std::span<const TimedPose> path,
                 const Stop& stop) {
  Coupling coupling = setup.coupling;
  coupling.max_force = coupling.max_torque = std::numeric_limits<double>::infinity();
  HapticLoop loop(setup.pair, method, coupling);
  ContactTorque contact_torque(setup.pair.probe(), setup.pair.fixed());
  const double k = stiffness_of(coupling);
  Rendering out;
  out.reserve(path.size());
  bool started = false;  // after a failed search there is no pose to follow: search again
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (stop && stop()) throw Cancelled();
    if (!started) loop.reset(path[i].pose, setup.search);
    const bool by_search = !started && loop.separation().fell();
    const double moved =
        i == 0 ? 0
               : Chart(setup.pair.probe().mass, path[i - 1].pose).coordinates(path[i].pose).norm();
    loop.tick(path[i].pose, i == 0 ? 0 : path[i].t - path[i - 1].t, setup.budget);
    out.push_back(tick_of(loop, path[i].t, moved));
    out.back().jumped |= by_search;
    if (method == Method::pdt) out.back().torque += k * contact_torque.at(loop.separation());
    started = started || !out.back().failed;
  }
  return out;
}

std::string to_json(const Rendering& rendering) {
  Json ticks = Json::array();
  for (const RenderedTick& tick : rendering) ticks.push_back(row_of(tick));
  // One tick per line, for people who read the file.
  std::string text = "{\"columns\":" + Json(names).dump() + ",\"ticks\":[";
  const char* separator = "\n";
  for (const Json& tick : ticks) {
    text.append(separator).append(tick.dump());
    separator = ",\n";
  }
  return text + "]}\n";
}

Rendering rendering_of(const std::string& json, const std::string& source) {
  try {
    Rendering out;
    const Json whole = Json::parse(json);
    for (const Json& tick : whole.at("ticks")) out.push_back(tick_of(tick.get<Row>()));
    return out;
  } catch (const Json::exception& error) {
    throw InputError::in(source, std::string("is no rendering: ") + error.what());
  }
}

}  // namespace sonde
