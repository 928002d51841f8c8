// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/query_motions.hpp"

#include <cmath>
#include <string>

#include "app/options.hpp"

namespace sonde::app {
namespace {

Vec3 vector_at(const std::vector<double>& numbers, std::size_t i) {
  return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

void check_vector(const Vec3& x, const std::string& what) {
  if (!x.allFinite()) throw UsageError(what + " must be finite");
  if (x.isZero(0)) throw UsageError(what + " must not be 0,0,0");
}

}  // namespace

void add_flags(CLI::App& parser, QueryMotions& motions) {
  const char* group = "Fewer motions than all (in the fixed body's frame)";
  parser
      .add_option("--along", motions.along,
                  "X,Y,Z: only displacements along it, one way; again for further directions")
      ->delimiter(',')
      ->expected(-3)
      ->allow_extra_args(false)
      ->group(group);
  parser
      .add_option("--about", motions.about,
                  "PX,PY,PZ,X,Y,Z: only turns about the axis X,Y,Z through the point, m")
      ->delimiter(',')
      ->expected(-6)
      ->allow_extra_args(false)
      ->group(group);
  parser
      .add_option("--in-plane", motions.in_plane,
                  "X,Y,Z: only sliding square to this normal, and turns about it; the answer is an "
                  "upper bound")
      ->delimiter(',')
      ->expected(-3)
      ->allow_extra_args(false)
      ->group(group);
  parser.add_flag("--no-turn", motions.sliding, "with --in-plane: no turns")->group(group);
}

void check(const QueryMotions& motions) {
  if (int(!motions.along.empty()) + int(!motions.about.empty()) + int(!motions.in_plane.empty()) >
      1)
    throw UsageError("--along, --about and --in-plane: give one of them");
  if (motions.sliding && motions.in_plane.empty())
    throw UsageError("--no-turn is of motions --in-plane");
  if (motions.along.size() % 3 != 0) throw UsageError("--along takes X,Y,Z for each direction");
  for (std::size_t i = 0; i < motions.along.size() / 3; ++i)
    check_vector(vector_at(motions.along, i), "the direction --along");
  if (!motions.about.empty()) {
    if (motions.about.size() != 6) throw UsageError("--about takes PX,PY,PZ,X,Y,Z, once");
    if (!vector_at(motions.about, 0).allFinite())
      throw UsageError("the point --about must be finite");
    check_vector(vector_at(motions.about, 1), "the axis --about");
  }
  if (!motions.in_plane.empty() && motions.in_plane.size() != 3)
    throw UsageError("--in-plane takes X,Y,Z, once");
  if (!motions.in_plane.empty())
    check_vector(vector_at(motions.in_plane, 0), "the normal --in-plane");
}

std::vector<std::vector<double>> QueryMotions::numbers() const {
  return {along, about, in_plane, {double(sliding)}};
}

Separation separate_within(const Pair& pair, const Pose& X_FM, const QueryMotions& motions,
                           const StaticOptions& options) {
  if (!motions.in_plane.empty())
    return separate_in_plane(pair, X_FM, {vector_at(motions.in_plane, 0), !motions.sliding},
                             options);
  if (!motions.about.empty())
    return separate_about(pair, X_FM, vector_at(motions.about, 0), vector_at(motions.about, 1));
  std::vector<Vec3> directions;
  directions.reserve(motions.along.size() / 3);
  for (std::size_t i = 0; i < motions.along.size() / 3; ++i)
    directions.push_back(vector_at(motions.along, i));
  return separate_along(pair, X_FM, directions);
}

}  // namespace sonde::app
