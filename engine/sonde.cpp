// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/sonde.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/effort.hpp"
#include "engine/base/numbers.hpp"
#include "engine/base/round_to_nearest.hpp"
#include "engine/body/body.hpp"
#include "engine/calibration/calibration_file.hpp"
#include "engine/haptics/coupling/coupler.hpp"
#include "engine/mending/repair_sentences.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/penetration/search/coherent.hpp"
#include "engine/penetration/search/option_check.hpp"
#include "engine/penetration/search/static_search.hpp"
#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {
namespace {

std::string numbered(const char* what, std::size_t i) {
  return std::string(what) + " " + std::to_string(i);
}

/// The triangles as the readers of files would give them, checked as they would.
PolygonSoup checked(std::span<const Vec3> vertices,
                    std::span<const std::array<std::uint32_t, 3>> triangles,
                    const std::string& name) {
  if (triangles.empty()) throw InputError::in(name, "no triangles");
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!vertices[i].allFinite())
      throw InputError::in(name, numbered("vertex", i) + " is not finite");
  PolygonSoup out{{vertices.begin(), vertices.end()}, {}};
  out.polygons.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::uint32_t corner : triangles[i])
      if (corner >= vertices.size())
        throw InputError::in(name, numbered("triangle", i) + ": there is no " +
                                       numbered("vertex", corner) + ", only " +
                                       std::to_string(vertices.size()));
    out.polygons.push_back({triangles[i].begin(), triangles[i].end()});
  }
  return out;
}

void check(const Knob& knob) {
  if (knob.time != 0 && knob.accuracy != 0)
    throw InputError::in("the knob", "a time and an accuracy: the one follows from the other");
  if (!(knob.time >= 0) || !std::isfinite(knob.time))
    throw InputError::in("the knob", "a time must be positive and finite");
  if (!(knob.accuracy >= 0 && knob.accuracy < 1))
    throw InputError::in("the knob", "an accuracy must be above 0 and below 1");
  if (!(knob.sure > 0 && knob.sure < 1))
    throw InputError::in("the knob", "how sure must be above 0 and below 1");
}

/// Radii of a body: an axis of turns further away makes a turn a displacement, to what is sensible.
constexpr double furthest_com = 1000;

void check(const Body& body, const MassProperties& mass) {
  const std::string& name = body.name;
  if (!(mass.measure > 0) || !std::isfinite(mass.measure))
    throw InputError::in(name, "the measure must be positive and finite");
  if (!mass.com.allFinite()) throw InputError::in(name, "the centre of mass is not finite");
  if (!((mass.com - body.mass.com).stableNorm() <= furthest_com * body.mass.radius))
    throw InputError::in(name, "the centre of mass is over 1000 radii away from the body's own");
  if (!mass.inertia.allFinite() || !(mass.inertia.minCoeff() >= 0))
    throw InputError::in(name, "the moments of inertia must be finite, and none negative");
  if (!(mass.inertia.maxCoeff() > 0))
    throw InputError::in(name, "the moments of inertia must not all be 0: no turn would count");
  const Mat3 off = mass.R_MP.transpose() * mass.R_MP - Mat3::Identity();
  if (!(off.cwiseAbs().maxCoeff() < 1e-9) || !(mass.R_MP.determinant() > 0))
    throw InputError::in(name, "the axes R_MP are no rotation");
}

Sentences sentences_of(const std::vector<std::string>& all) {
  return {all.data(), all.data() + all.size()};
}

}  // namespace

std::shared_ptr<const Body> read_body(const std::filesystem::path& file, Model model, double scale,
                                      const Progress& progress, Repair repair) {
  const RoundToNearest round_to_nearest;
  if (!(scale > 0) || !std::isfinite(scale))
    throw InputError::in(file.string(), "the scale must be positive and finite");
  return load_body(file.string(), model, scale, progress, repair);
}

std::shared_ptr<const Body> make_body(std::span<const Vec3> vertices,
                                      std::span<const std::array<std::uint32_t, 3>> triangles,
                                      Model model, const std::string& name, Repair repair,
                                      const Progress& progress) {
  const RoundToNearest round_to_nearest;
  return make_body(checked(vertices, triangles, name), model, name, progress, repair);
}

std::shared_ptr<const Body> offset_body(const Body& body, double by, const Progress& progress) {
  const RoundToNearest round_to_nearest;
  return offset_faces(body, by, progress);
}

std::shared_ptr<const Body> with_mass(const Body& body, const MassProperties& mass) {
  const RoundToNearest round_to_nearest;
  check(body, mass);
  return with_other_mass(body, mass);
}

BodyFacts facts(const Body& body) {
  return {.name = body.name,
          .triangles = body.soup.triangles.size(),
          .degenerate = body.degenerate,
          .solid = body.solid,
          .why = body.why,
          .mass_why = body.mass_why,
          .turned = body.turned,
          .repairs = body.repairs,
          .mended = sentences_of(sentences(body.repairs)),
          .remarks = sentences_of(body.remarks),
          .mass = body.mass,
          .offset = body.offset};
}

std::span<const Vec3> vertices(const Body& body) { return body.soup.vertices; }
std::span<const std::array<std::uint32_t, 3>> triangles(const Body& body) {
  return body.soup.triangles;
}

Separation separate(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                    const Progress& progress) {
  const RoundToNearest round_to_nearest;
  check(options);
  return separate_static(pair, X_FM, options, progress);
}

SignedDistance signed_distance(const Pair& pair, const Pose& X_FM, const StaticOptions& options,
                               const Progress& progress) {
  const RoundToNearest round_to_nearest;
  SignedDistance out;
  out.clearance = distance(pair, X_FM);
  StaticOptions own = options;
  own.want_clearance = false;
  out.separation = separate(pair, X_FM, own, progress);
  if (!out.clearance.overlapping)
    out.distance = out.clearance.distance;
  else if (out.separation.status != Status::failed)
    out.distance = 0 - out.separation.depth;  // no -0
  else
    out.distance = no_number;
  return out;
}

Answer separate(const Pair& pair, const Pose& X_FM, const Knob& knob, Method method,
                std::uint64_t seed) {
  const RoundToNearest round_to_nearest;
  check(knob);
  const AccuracyCurve curve(default_calibration(), Answers::search, method, bool(pair.sketches()),
                            knob.sure);
  StaticOptions options;
  options.method = method;
  options.seed = seed;
  options.sure = knob.sure;
  options.budget.microseconds = budget_us(knob, curve);
  options.want_lower_bound = false;
  const double limit = options.budget.microseconds, begin = now_us();
  const Separation found = separate_static(pair, X_FM, options);
  const bool late = limit > 0 && now_us() - begin > not_late * limit;
  return {found, claim_of(found, limit, curve), late};
}

struct Follower::State {
  CoherentSolver solver;
};

Follower::Follower(const Pair& pair, Method method)
    : state_(std::make_unique<State>(State{CoherentSolver(pair, method)})) {}
Follower::~Follower() = default;
Follower::Follower(Follower&&) noexcept = default;
Follower& Follower::operator=(Follower&&) noexcept = default;

Follower::Follower(const Follower& other) : state_(std::make_unique<State>(*other.state_)) {}
Follower& Follower::operator=(const Follower& other) {
  if (this != &other) *this = Follower(other);
  return *this;
}

const Separation& Follower::start(const Pose& X_FM, const StaticOptions& options,
                                  const Progress& progress) {
  const RoundToNearest round_to_nearest;
  check(options);
  return state_->solver.reset(X_FM, options, progress);
}

const Separation& Follower::follow(const Pose& X_FM, const Budget& budget) noexcept {
  const RoundToNearest round_to_nearest;
  return state_->solver.tick(X_FM, budget);
}

void Follower::time_phases(bool on) noexcept { state_->solver.time_phases(on); }

const Separation& Follower::last() const noexcept { return state_->solver.last(); }

Wrench wrench(const Pair& pair, const Separation& now, const Coupling& coupling) noexcept {
  const RoundToNearest round_to_nearest;
  return Coupler(pair.probe().mass, coupling).wrench(now, 0);
}

Wrench wrench(const Pair& pair, const Separation& now, const Separation& before, double dt,
              const Coupling& coupling) noexcept {
  const RoundToNearest round_to_nearest;
  Coupler coupler(pair.probe().mass, coupling);
  coupler.wrench(before, 0);
  return coupler.wrench(now, dt);
}

}  // namespace sonde
