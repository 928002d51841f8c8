// SPDX-License-Identifier: GPL-3.0-or-later
// Where the members of the public types lie, and one answer: the same whatever the flags are that
// this is compiled with, since the library was compiled with its own.
#include <cstdio>
#include <sonde/sonde.hpp>
#include <string>
#include <vector>

namespace {

template <class Whole, class Part>
void say(const char* name, const Whole& whole, const Part& part) {
  const auto at = reinterpret_cast<const char*>(&part) - reinterpret_cast<const char*>(&whole);
  std::printf("%s at %td, size %zu of %zu, aligned to %zu and %zu\n", name, at, sizeof(part),
              sizeof(whole), alignof(Part), alignof(Whole));
}

}  // namespace

#define SAY(whole, member) say(#whole "." #member, whole, whole.member)

int main() {
  const sonde::Pose pose{sonde::Quat(0.9, 0.1, 0.2, 0.3).normalized(),
                         sonde::Vec3(0.04, 0.03, 0.02)};
  SAY(pose, q), SAY(pose, p);
  std::vector<sonde::Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(0.1 * sonde::Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  std::vector<std::array<std::uint32_t, 3>> faces{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                                  {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                                  {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const auto box = sonde::make_body(corners, faces);
  const sonde::Pair pair(box, box);

  sonde::StaticOptions options;
  SAY(options, method), SAY(options, budget), SAY(options, seed), SAY(options, starts);
  SAY(options, sure), SAY(options, by_evidence), SAY(options, share_for_bound);
  SAY(options, want_clearance), SAY(options, two_threads);
  const sonde::Separation found = sonde::separate(pair, pose, options);
  SAY(found, status), SAY(found, device), SAY(found, separated), SAY(found, depth);
  SAY(found, contacts), SAY(found, clusters), SAY(found, residual), SAY(found, limited);
  SAY(found, released), SAY(found, far_out), SAY(found, lower_bound), SAY(found, pdt);
  SAY(found, clearance), SAY(found, phases);
  const sonde::Contact& contact = found.contacts.items[0];
  SAY(contact, on_fixed), SAY(contact, normal), SAY(contact, multiplier);
  const sonde::ContactCluster& cluster = found.clusters.items[0];
  SAY(cluster, pitch), SAY(cluster, id);
  const sonde::BodyFacts facts = sonde::facts(*box);
  SAY(facts, mended), SAY(facts, remarks), SAY(facts, mass), SAY(facts, offset);
  SAY(facts.mass, com), SAY(facts.mass, inertia), SAY(facts.mass, radius);
  // Its principal axes are no symmetric matrix, and it had to be mended: one triangle is twice
  // there.
  for (sonde::Vec3& corner : corners)
    corner = pose.q * sonde::Vec3(corner.x(), 2 * corner.y(), 3 * corner.z());
  faces.push_back(faces.front());
  const sonde::BodyFacts tilted = sonde::facts(*sonde::make_body(corners, faces));
  const sonde::Answer answer = sonde::separate(pair, pose, sonde::Knob{});
  SAY(answer, claim), SAY(answer, late);
  const sonde::Coupling coupling;
  SAY(coupling, k), SAY(coupling, max_torque);
  const sonde::Wrench wrench = sonde::wrench(pair, found, coupling);
  SAY(wrench, force), SAY(wrench, torque), SAY(wrench, saturated);
  const sonde::WrenchDerivative derivative = sonde::wrench_derivative(pair, found);
  SAY(derivative, sides), SAY(derivative, reason), SAY(derivative, d_depth);
  SAY(derivative, d_wrench), SAY(derivative, d_separated), SAY(derivative, d_wrench_held);
  SAY(derivative, leaves);
  const sonde::PrincipalStiffnesses felt = sonde::principal_stiffnesses(derivative, 500);
  SAY(felt, rotation), SAY(felt.rotation[0], direction);

  const sonde::Clearance apart = sonde::distance(pair, {pose.q, sonde::Vec3(0.3, 0.2, 0.1)});
  SAY(apart, on_probe), SAY(apart, on_fixed), SAY(apart, overlapping);
  const sonde::SweptPath path = sonde::sweep(pair, {pose.q, sonde::Vec3(0.3, 0, 0)}, pose);
  SAY(path, hit), SAY(path, X_FM), SAY(path, contact);
  const sonde::SurfacePoint near = sonde::nearest_point(*box, sonde::Vec3(0.3, 0.05, 0.04));
  SAY(near, normal), SAY(near, distance);
  std::printf("apart %.17g, free %.17g, near %.17g\n", apart.distance, path.free, near.distance);
  const sonde::SignedDistance distance = sonde::signed_distance(pair, pose);
  SAY(distance, clearance), SAY(distance, separation);

  // What the library wrote is read where it wrote it.
  std::printf("depth %.17g, contacts %d, turn %.17g %.17g %.17g %.17g\n", found.depth,
              found.contacts.size, found.separated.q.w(), found.separated.q.x(),
              found.separated.q.y(), found.separated.q.z());
  for (const sonde::Contact& c : found.contacts)
    std::printf("contact %.17g %.17g %.17g, %.17g\n", c.normal.x(), c.normal.y(), c.normal.z(),
                c.multiplier);
  for (int i = 0; i < 6; ++i)
    std::printf("derivative %.17g, %.17g\n", derivative.d_depth[i], derivative.d_wrench(i, i));
  std::printf("mass %.17g of radius %.17g\n", facts.mass.measure, facts.mass.radius);
  for (int i = 0; i < 3; ++i)
    std::printf("axes %.17g %.17g %.17g\n", tilted.mass.R_MP(i, 0), tilted.mass.R_MP(i, 1),
                tilted.mass.R_MP(i, 2));
  for (const std::string& sentence : tilted.mended) std::printf("mended: %s\n", sentence.c_str());

  // A follower from free to an overlap of 10 mm: one axis at a time, so that it is not out by a
  // turn.
  sonde::Follower follower(pair);
  follower.start({sonde::Quat::Identity(), sonde::Vec3(0, 0, 0.105)});
  for (int i = 1; i <= 15; ++i)
    follower.follow({sonde::Quat::Identity(), sonde::Vec3(0, 0, 0.105 - 0.001 * i)});
  std::printf("followed %.17g %d\n", follower.last().depth, follower.last().converged);
  return 0;
}
