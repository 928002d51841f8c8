// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/stability/contact_situations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.hpp"
#include "engine/base/threads.hpp"
#include "engine/body/body.hpp"
#include "engine/geometry/random.hpp"
#include "engine/geometry/rotation.hpp"
#include "engine/penetration/search/coherent.hpp"

namespace sonde {
namespace {

/// Steps of a walk, as a share of the probe's radius, and of the differences that measure
/// stiffness, as a share of the depth.
constexpr double walk_step = 0.02;
constexpr double difference_step = 0.03;
/// Ticks within a walk are limited: where surfaces lie on each other they could take seconds.
constexpr Budget walk_budget{.steps = 60};

struct Box {
  Vec3 low = Vec3::Constant(INFINITY), high = Vec3::Constant(-INFINITY);
};
Box box_of(const Body& body) {
  Box box;
  for (const Vec3& x : body.soup.vertices) {
    box.low = box.low.cwiseMin(x);
    box.high = box.high.cwiseMax(x);
  }
  return box;
}

Vec3 in_box(Random& random, const Box& box) {
  Vec3 out;
  for (int i = 0; i < 3; ++i) out[i] = random.uniform(box.low[i], box.high[i]);
  return out;
}

Vec3 direction(Random& random) {
  for (;;) {
    // One by one: in what order the arguments of a call are computed is left to the compiler.
    Vec3 x;
    for (int i = 2; i >= 0; --i) x[i] = random.uniform(-1, 1);
    const double length = x.norm();
    if (length > 1e-3 && length <= 1) return x / length;
  }
}

Quat near_rotation(Random& random, const Quat& q) {
  const double angle = random.uniform(0, std::numbers::pi / 6);
  return rotation_about(direction(random), angle) * q;
}

/// Collects situations as they are found, and sorts them at the end.
class Collection {
 public:
  Collection(const Pair& pair, const SituationOptions& options) : pair_(pair), options_(options) {}

  struct Found {
    ContactSituation situation;
    double hardness;
  };

  /// Takes long; on any thread.
  std::optional<Found> look(const Separation& s) const {
    const auto stiffness =
        felt_stiffness(pair_, options_.method, s.device, s.separated, difference_step * s.depth);
    if (!stiffness) return {};
    const double hardness = options_.hardness(*stiffness);
    if (!std::isfinite(hardness)) return {};
    return Found{{contact_kind(s), s, *stiffness}, hardness};
  }

  void add(const std::optional<Found>& found) {
    if (found) found_.push_back(*found);
  }

  void tell(double done) const {
    if (options_.progress) options_.progress(done);
  }

  std::vector<ContactSituation> best(int most) {
    std::ranges::stable_sort(found_, [](const Found& a, const Found& b) {
      if (a.situation.kind != b.situation.kind) return a.situation.kind < b.situation.kind;
      return a.hardness > b.hardness;
    });
    std::vector<ContactSituation> out;
    int of_kind = 0;
    for (const Found& found : found_) {
      const bool same = !out.empty() && out.back().kind == found.situation.kind;
      of_kind = same ? of_kind + 1 : 1;
      if (of_kind <= most) out.push_back(found.situation);
    }
    return out;
  }

 private:
  const Pair& pair_;
  const SituationOptions& options_;
  std::vector<Found> found_;
};

/// A straight path of the probe's centre of mass.
struct Walk {
  Quat q;
  Vec3 from, to;
};

Walk random_walk(Random& random, const Body& probe, const Body& fixed, const Box& box,
                 const Pose& X_FM) {
  const bool anyhow = random.next() % 2 == 0;
  const Quat q = anyhow ? random.rotation() : near_rotation(random, X_FM.q);
  const double away = fixed.mass.radius + (box.high - box.low).norm() + 1.01 * probe.mass.radius;
  const Vec3 to = in_box(random, box);
  return {q.normalized(), to + away * direction(random), to};
}

/// Follows a walk until the probe is deep enough. No value if it never is.
std::optional<Separation> arrive(CoherentSolver& solver, const Body& probe, const Walk& walk,
                                 double depth) {
  const auto pose = [&](double s) {
    return Pose{walk.q, walk.from + s * (walk.to - walk.from) - walk.q * probe.mass.com};
  };
  const int steps =
      static_cast<int>(std::ceil((walk.to - walk.from).norm() / (walk_step * probe.mass.radius)));
  solver.reset(pose(0));
  for (int i = 1; i <= steps; ++i) {
    const Separation& s = solver.tick(pose(double(i) / steps), walk_budget);
    if (s.status == Status::failed) return std::nullopt;
    if (s.depth >= depth)
      return s.converged && s.contacts.size > 0 ? std::optional(s) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

const char* name_of(ContactKind kind) {
  constexpr std::array names{"flat", "edge", "conforming", "corner", "jammed"};
  return names[static_cast<std::size_t>(kind)];
}

ContactKind contact_kind(const Separation& s) {
  if (s.clusters.size > 1) {
    for (int i = 0; i < s.clusters.size; ++i)
      for (int j = 0; j < i; ++j)
        if (s.clusters[i].contact.normal.dot(s.clusters[j].contact.normal) <= -0.5)
          return ContactKind::jammed;
    return ContactKind::corner;
  }
  const int rows = s.contacts.size;
  return rows <= 1 ? ContactKind::flat : rows == 2 ? ContactKind::edge : ContactKind::conforming;
}

std::vector<ContactSituation> find_situations(const Pair& pair, const Pose& X_FM, int most,
                                              const SituationOptions& options, const Stop& stop) {
  Collection collection(pair, options);
  const Box box = box_of(pair.fixed());
  Random random(options.seed);
  std::vector<Walk> walks;
  walks.reserve(static_cast<std::size_t>(std::max(0, options.walks)));
  for (int i = 0; i < options.walks; ++i)
    walks.push_back(random_walk(random, pair.probe(), pair.fixed(), box, X_FM));
  const double depth = options.depth * pair.probe().mass.radius;
  const auto walk = [&](std::size_t i) {
    if (stop()) throw Cancelled();
    CoherentSolver solver(pair, options.method);
    const auto s = arrive(solver, pair.probe(), walks[i], depth);
    return s ? collection.look(*s) : std::nullopt;
  };
  run_in_order(walks.size(), options.threads, walk, [&](std::size_t i, const auto& found) {
    collection.tell(double(i) / options.walks);
    collection.add(found);
  });
  return collection.best(most);
}

std::vector<ContactSituation> situations_along(const Pair& pair, std::span<const TimedPose> path,
                                               int most, const SituationOptions& options,
                                               const Stop& stop) {
  constexpr std::size_t looked_at = 200;
  Collection collection(pair, options);
  CoherentSolver solver(pair, options.method);
  std::vector<Separation> touching;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (stop()) throw Cancelled();
    const Separation& s =
        i == 0 ? solver.reset(path[i].pose) : solver.tick(path[i].pose, walk_budget);
    if (s.status == Status::penetrating && s.converged && s.contacts.size > 0)
      touching.push_back(s);
  }
  const std::size_t every = touching.size() / looked_at + 1;
  const auto look = [&](std::size_t i) {
    if (stop()) throw Cancelled();
    return collection.look(touching[i * every]);
  };
  const std::size_t looked = (touching.size() + every - 1) / every;
  run_in_order(looked, options.threads, look, [&](std::size_t i, const auto& found) {
    collection.tell(double(i) / double(looked));
    collection.add(found);
  });
  return collection.best(most);
}

}  // namespace sonde
