// SPDX-License-Identifier: GPL-3.0-or-later
// Every function of the public header, once: what is declared is also there to be linked. The boxes
// overlap by 0.1 m along x and more elsewhere: the nearest way out is that long.
#include <cmath>
#include <cstdio>
#include <sonde/sonde.hpp>
#include <utility>
#include <vector>

namespace {

std::shared_ptr<const sonde::Body> box() {
  std::vector<sonde::Vec3> vertices;
  for (int i = 0; i < 8; ++i)
    vertices.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
  const std::vector<std::array<std::uint32_t, 3>> triangles = {
      {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return sonde::make_body(vertices, triangles, sonde::Model::solid, "box");
}

bool read_is_refused() {
  try {
    sonde::read_body("/nowhere/at-all.off");
  } catch (const sonde::InputError&) {
    return true;
  }
  return false;
}

int complain(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  return 1;
}

}  // namespace

int main() {
  static_assert(SONDE_VERSION_MAJOR >= 0 && SONDE_VERSION_MINOR >= 0 && SONDE_VERSION_PATCH >= 0);
  if (!read_is_refused()) return complain("a missing file was not refused as InputError");
  const auto body = box();
  const sonde::BodyFacts known = sonde::facts(*body);
  if (!known.solid || std::abs(known.mass.measure - 1) > 1e-12) return complain("facts");
  if (sonde::facts(*sonde::offset_body(*body, -0.01)).offset.by != -0.01)
    return complain("an allowance");
  if (sonde::vertices(*body).size() != 8 || sonde::triangles(*body).size() != 12)
    return complain("the mesh of a body");
  const sonde::Pair pair(body, body);
  sonde::Pose pose;
  pose.p.x() = 0.9;
  const sonde::Separation deep = sonde::separate(pair, pose);
  if (deep.status != sonde::Status::penetrating || deep.depth > 0.1 * 1.0001)
    return complain("the depth is above the way out along x");
  pose.p.x() = -0.9;
  const sonde::Separation back = sonde::separate(pair.exchanged(), pose);
  if (std::abs(back.depth - deep.depth) > 1e-3 * deep.depth) return complain("exchanged bodies");
  pose.p.x() = 0.9;
  const sonde::Answer quick = sonde::separate(pair, pose, sonde::Knob{.time = 1e-3});
  if (quick.separation.status != sonde::Status::penetrating) return complain("the knob");
  sonde::Follower first(pair), follower(std::move(first));
  first = std::move(follower);
  follower = std::move(first);
  if (sonde::seed_of_pose(1, pose) == sonde::seed_of_pose(2, pose)) return complain("seeds");
  if (sonde::fingerprint(*body) == 0) return complain("a fingerprint");
  if (!sonde::touch(pair, pose)) return complain("they touch");
  const sonde::SignedDistance depth = sonde::signed_distance(pair, pose);
  if (depth.distance != -depth.separation.depth) return complain("a distance less than 0");
  pose.p.x() = 1.1;
  if (std::abs(sonde::distance(pair, pose).distance - 0.1) > 1e-12) return complain("a clearance");
  const sonde::SweptPath path = sonde::sweep(pair, pose, {pose.q, sonde::Vec3(0.6, 0, 0)});
  if (!path.hit || std::abs(path.free - 0.2) > 1e-6) return complain("a path");
  if (!sonde::inside(*body, {0.4, 0, 0})) return complain("inside");
  if (sonde::nearest_point(*body, {0.7, 0, 0}).point.x() != 0.5) return complain("nearest");
  if (!sonde::ray(*body, {2, 0.1, 0.2}, {-1, 0, 0})) return complain("a ray");
  if (sonde::part_at(*body, {0.5, 0, 0}) != "box") return complain("the part of a body");
  sonde::MassProperties heavy = known.mass;
  heavy.inertia *= 4;
  if (sonde::facts(*sonde::with_mass(*body, heavy)).mass.inertia != heavy.inertia)
    return complain("another norm");
  follower.time_phases(true);
  follower.start(pose);
  sonde::Follower other(follower);
  other = follower;
  pose.p.x() = 1.05;
  const sonde::Separation now = follower.follow(pose);
  if (now.status != sonde::Status::separated || follower.last().depth != 0) return complain("free");
  const sonde::Coupling coupling;
  const sonde::Wrench pushed = sonde::wrench(pair, deep, coupling);
  const sonde::Wrench damped = sonde::wrench(pair, deep, now, 1e-3, coupling);
  if (!(pushed.force.norm() > 0) || !(damped.force.norm() > 0)) return complain("no force");
  const sonde::WrenchDerivative derivative =
      sonde::wrench_derivative(pair, deep, sonde::Neighbours::all);
  if (derivative.sides == sonde::WrenchDerivative::Sides::none && !*derivative.reason)
    return complain("no derivative and no reason");
  const sonde::PrincipalStiffnesses felt = sonde::principal_stiffnesses(derivative, 500);
  if (felt.translation[0].value < felt.translation[2].value) return complain("stiffnesses");
  return 0;
}
