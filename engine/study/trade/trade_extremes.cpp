// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/trade/trade_extremes.hpp"

#include <cmath>

#include "engine/base/error.hpp"
#include "engine/base/numbers.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/bound/lower_bound.hpp"
#include "engine/penetration/search/static_search.hpp"

namespace sonde {
namespace {

/// The position and scale of both meshes.
struct World {
  const char* name;
  double scale;
  double away;  ///< in radii of the probe, before scaling
};
constexpr World as_given{"as given", 1, 0};
constexpr World extremes[] = {{"tiny", 0x1p-20, 0}, {"huge", 0x1p20, 0}, {"far", 1, 1e4}};

struct Asked {
  TradeKind kind;
  Method method;
};
constexpr Asked all_asked[] = {{TradeKind::search, Method::pdg},
                               {TradeKind::search, Method::pdt},
                               {TradeKind::bound, Method::pdg}};

std::shared_ptr<const Body> moved(const Body& body, double scale, const Vec3& shift) {
  PolygonSoup out;
  for (const Vec3& x : body.soup.vertices) out.points.push_back(scale * x + shift);
  for (const Triangle& t : body.soup.triangles) out.polygons.push_back({t[0], t[1], t[2]});
  return make_body(out,
                   !body.solid          ? Model::surface
                   : body.loose.empty() ? Model::solid
                                        : Model::automatic,
                   body.name);
}

/// The two bodies in a world, and the answers there. All lengths are converted to those of the
/// given world.
class Measurement {
 public:
  Measurement(const Pair& pair, const World& world)
      : scale_(world.scale),
        shift_(
            Vec3::Constant(world.scale * world.away * pair.probe().mass.radius / std::sqrt(3.0))),
        pair_(moved(pair.probe(), scale_, shift_), moved(pair.fixed(), scale_, shift_)) {}

  double depth(const Pose& X_FM, const Asked& asked, std::uint64_t seed) const {
    const Pose X{X_FM.q, scale_ * X_FM.p + shift_ - X_FM.q * shift_};
    if (asked.kind == TradeKind::bound)
      return depth_lower_bound(pair_.probe(), pair_.fixed(), X).value_or(no_number) / scale_;
    StaticOptions options;
    options.method = asked.method;
    options.seed = seed;
    options.want_lower_bound = false;
    const Separation found = separate_static(pair_, X, options);
    return found.status == Status::failed ? no_number : found.depth / scale_;
  }

 private:
  double scale_;
  Vec3 shift_;
  Pair pair_;
};

/// The answers for every pose and query, in sequence.
std::vector<double> depths(const Pair& pair, const World& world, std::span<const Pose> poses,
                           std::uint64_t seed, const Stop& stop) {
  std::vector<double> out;
  try {
    const Measurement there(pair, world);
    for (const Asked& asked : all_asked)
      for (std::size_t i = 0; i < poses.size(); ++i) {
        if (stop()) throw Cancelled();
        out.push_back(there.depth(poses[i], asked, seed + i));
      }
  } catch (const InputError&) {  // the mesh is not a valid body there
    out.assign(std::size(all_asked) * poses.size(), no_number);
  }
  return out;
}

}  // namespace

std::vector<TradeExtreme> measure_extremes(const Pair& pair, std::span<const Pose> poses,
                                           std::uint64_t seed, const Stop& stop) {
  // The given world also uses a newly built body, whose triangles are in another order.
  const std::vector<double> given = depths(pair, as_given, poses, seed, stop);
  std::vector<TradeExtreme> out;
  for (const World& world : extremes) {
    const std::vector<double> there = depths(pair, world, poses, seed, stop);
    std::size_t at = 0;
    for (const Asked& asked : all_asked) {
      TradeExtreme extreme{world.name, asked.kind, asked.method, {}};
      for (std::size_t i = 0; i < poses.size(); ++i, ++at)
        extreme.change.push_back(there[at] == given[at] ? 0 : there[at] / given[at] - 1);
      if (asked.kind == TradeKind::search || pair.probe().solid || pair.fixed().solid)
        out.push_back(extreme);
    }
  }
  return out;
}

}  // namespace sonde
