// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/bound/lower_bound.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/base/numbers.hpp"
#include "engine/base/ordering.hpp"
#include "engine/penetration/bound/bound_tuning.hpp"
#include "engine/penetration/bound/crossing.hpp"
#include "engine/penetration/bound/deep_points.hpp"
#include "engine/penetration/bound/rotation_cell.hpp"
#include "engine/penetration/bound/witness.hpp"

namespace sonde {
namespace {

/// μ(r) = max over unit n in the range of Î of |n×r|² / (nᵀÎn), r in principal axes; infinite if a
/// turn without cost moves the point. Rounded up.
double leverage(const Vec3& inertia, const Vec3& r) {
  const Mat3 arm = r.squaredNorm() * Mat3::Identity() - r * r.transpose();
  Vec3 scale;
  for (int i = 0; i < 3; ++i) {
    if (inertia[i] > 0) {
      scale[i] = 1 / std::sqrt(inertia[i]);
    } else {
      // Off the axis of a line-like probe, even if only by rounding, the bound proves nothing.
      if (arm(i, i) > 1e-12 * inertia.maxCoeff()) return infinity;
      scale[i] = 0;
    }
  }
  const Mat3 weighted = scale.asDiagonal() * arm * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(weighted, Eigen::EigenvaluesOnly);
  return std::max(0.0, solver.eigenvalues()[2]) * (1 + 1e-12);
}

/// The lower bound over all rotations that one point proves.
double bound_of(const CommonPoint& s, const Vec3& inertia) {
  return s.depth() > 0 ? s.depth() / std::sqrt(1 + leverage(inertia, s.r)) : 0;
}

/// Branch and bound over rotations. For every turn of a cell, the centre of mass must move at least
/// as far as the best witness at the cell's middle requires, less the displacement that the turns
/// of the cell can cause. The cell with the least bound is refined: by a search for deeper points
/// at its middle, or by bisection.
class TurnSearch {
 public:
  TurnSearch(const CommonDepth& depth, const std::vector<CommonPoint>& points)
      : depth_(depth), inertia_(depth.probe().mass.inertia) {
    for (const CommonPoint& s : points) witnesses_.push_back(s.witness());
    for (int face = 0; face < 4; ++face) {
      Node n;
      n.cell.face = face;
      add(n);
    }
  }

  /// Returns the least bound of all cells, m, when the work is used up, or when an increase of the
  /// work by half has hardly raised the bound.
  double run(int work, const Deadline& deadline) {
    double before = 0;
    for (double look = bound_tuning.first_look; spent() < work && !deadline.passed();) {
      if (spent() >= look) {
        const double now = std::sqrt(queue_.top().bound);
        if (now < bound_tuning.worth_going_on * before) break;
        before = now, look *= bound_tuning.look_growth;
      }
      const std::uint32_t i = queue_.top().node;
      queue_.pop();
      if (nodes_[i].seen < witnesses_.size()) {
        update(nodes_[i]);
        if (nodes_[i].bound > queue_.top().bound) {
          queue_.push({nodes_[i].bound, i});
          continue;
        }
      }
      refine(i);
    }
    return std::sqrt(queue_.top().bound);
  }

 private:
  static constexpr std::size_t most_near = bound_tuning.most_near;
  struct Near {
    double depth;           // at the cell's middle, m
    double away;            // |R r − p| there, m
    std::uint32_t witness;  // its index in witnesses_
  };
  struct Node {
    RotationCell cell;
    double bound = 0;  // lower bound of σ in the cell, m²
    double reach = 0;  // displacement of the best witness's r by the cell's turns, m
    std::size_t best = 0;
    std::size_t seen = 0;  // number of witnesses considered so far
    std::size_t count = 0;
    std::array<Near, most_near> near;  // the deepest at the middle, deepest first
    bool queried = false;
  };
  struct Open {
    double bound;
    std::uint32_t node;
    bool operator<(const Open& o) const {
      return bound != o.bound ? bound > o.bound : node > o.node;
    }
  };

  int spent() const { return bound_tuning.work_of_evaluation * depth_.evaluations() + cells_; }

  void consider(Node& n, const CellSpread& spread, std::uint32_t witness) const {
    const Witness& w = witnesses_[witness];
    const double away = (spread.middle() * w.r - w.p).norm(), depth = w.depth - away;
    if (n.count == most_near && depth <= n.near[most_near - 1].depth) return;
    if (n.count < most_near) ++n.count;
    std::size_t i = n.count - 1;
    for (; i > 0 && n.near[i - 1].depth < depth; --i) n.near[i] = n.near[i - 1];
    n.near[i] = {depth, away, witness};
  }

  void set_bound(Node& n, const CellSpread& spread) {
    double most = -infinity;
    for (std::size_t i = 0; i < n.count && n.near[i].depth > most; ++i) {
      const double reach = spread.reach(witnesses_[n.near[i].witness].r);
      if (n.near[i].depth - reach > most)
        most = n.near[i].depth - reach, n.best = i, n.reach = reach;
    }
    ++cells_;
    const double way = std::max(0.0, most);
    n.bound = std::max(n.bound, n.cell.least_cost(inertia_) + way * way);
    if (way > 0) n.bound = std::max(n.bound, least_sum(n, spread));
  }

  /// A joint bound of the cost of the turn and the displacement of the centre of mass, for cells in
  /// which different turns minimise the two. With a = |R r − p| and D the witness's depth, for any
  /// a₀ in (0, D]
  ///   (D − a)² ≥ D² − D a₀ − (D/a₀ − 1) a²,   equal at a = a₀,
  /// so that with the cost it is a ratio of quadratic forms. The deepest witness at the middle is
  /// evaluated at two tangent points a₀: one that suits the cell's size, and the a at which the
  /// first form was least.
  double least_sum(const Node& n, const CellSpread& spread) const {
    const Witness& w = witnesses_[n.near[0].witness];
    const Eigen::Matrix4d G = distance_form(w.r, w.p);
    const double least_away = bound_tuning.least_away * w.depth;
    double away =
        std::max({n.near[0].away, bound_tuning.first_away * spread.reach(w.r), least_away});
    double most = -infinity;
    Eigen::Vector4d at = n.cell.middle();
    for (int i = 0; i < bound_tuning.tangents && away < w.depth; ++i) {
      Eigen::Matrix4d S = (1 - w.depth / away) * G;
      S.diagonal().tail<3>() += 4 * inertia_;
      const RotationCell::Least least = n.cell.least_quotient(S, at);
      most = std::max(most, w.depth * ((1 - 1e-14) * w.depth - away) + least.bound);
      at = least.at;
      away = std::max(std::sqrt(at.dot(G * at) / at.squaredNorm()), least_away);
    }
    return most;
  }

  /// Considers the witnesses found since the last update, but only the latest `most_new` of them:
  /// those from distant cells matter least.
  void update(Node& n) {
    n.seen =
        std::max(n.seen, witnesses_.size() - std::min(bound_tuning.most_new, witnesses_.size()));
    const CellSpread spread(n.cell);
    for (; n.seen < witnesses_.size(); ++n.seen)
      consider(n, spread, static_cast<std::uint32_t>(n.seen));
    set_bound(n, spread);
  }

  void add(Node n) {
    update(n);
    queue_.push({n.bound, static_cast<std::uint32_t>(nodes_.size())});
    nodes_.push_back(n);
  }

  Node child_of(const Node& n, const RotationCell& cell) {
    Node c;
    c.cell = cell, c.bound = n.bound, c.seen = n.seen;
    const CellSpread spread(cell);
    for (std::size_t i = 0; i < n.count; ++i) consider(c, spread, n.near[i].witness);
    set_bound(c, spread);
    return c;
  }

  void refine(std::uint32_t i) {
    Node& n = nodes_[i];
    const CellSpread spread(n.cell);
    // The bound of a witness that was found at a distant rotation is weaker by the displacement of
    // r; a witness found at this cell may be much better.
    if (!n.queried && n.near[n.best].away > bound_tuning.from_afar * n.reach) {
      n.queried = true;
      find_witness(n, spread);
      queue_.push({n.bound, i});
      return;
    }
    const auto halves = n.cell.halves(widest(n, spread));
    const Node low = child_of(n, halves[0]), high = child_of(n, halves[1]);
    n = low;
    queue_.push({low.bound, i});
    queue_.push({high.bound, static_cast<std::uint32_t>(nodes_.size())});
    nodes_.push_back(high);  // n is gone
  }

  /// The component along which the bound of σ varies most.
  int widest(const Node& n, const CellSpread& spread) const {
    const Near& best = n.near[n.best];
    int widest = 0;
    double most = -1;
    for (int i = 0; i < 3; ++i) {
      const double way = spread.reach_along(i, witnesses_[best.witness].r);
      const double change = 2 * std::max(0.0, best.depth) * way + n.cell.cost_along(i, inertia_);
      if (change > most) most = change, widest = i;
    }
    return widest;
  }

  /// Searches for a point deep in both bodies at the cell's middle, from the best known witness.
  void find_witness(const Node& n, const CellSpread& spread) {
    const Mat3& R = spread.middle();
    const Witness& w = witnesses_[n.near[0].witness];
    // If a body is a surface, only points on it can be deep in both.
    Vec3 x = (R * w.r + w.p) / 2;
    if (!depth_.probe().solid) x = R * w.r;
    if (!depth_.fixed().solid) x = w.p;
    const CommonPoint here = depth_.at(R, x);
    const CommonPoint best =
        depth_.ascend(R, here, bound_tuning.stride * std::abs(here.depth()), bound_tuning.ascent);
    if (best.depth() > 0) witnesses_.push_back(best.witness());
  }

  const CommonDepth& depth_;
  Vec3 inertia_;
  std::vector<Witness> witnesses_;
  std::vector<Node> nodes_;
  ordering::Queue<Open> queue_;
  int cells_ = 0;
};

/// What points that lie in both bodies prove.
LowerBound bound_by_points(const Body& probe, const Body& fixed, const Pose& X_FM,
                           const Deadline& deadline, const BoundOptions& options) {
  const CommonDepth depth(probe, fixed, X_FM);
  const std::vector<CommonPoint> points = deep_points(depth, options.work, deadline);
  LowerBound bound;
  if (points.empty()) return bound;
  double most = 0;
  for (const CommonPoint& s : points) {
    const double alone = options.translations ? s.depth() : bound_of(s, probe.mass.inertia);
    if (alone <= most) continue;
    most = alone;
    bound.witness = BoundWitness{depth.X_FW() * s.x, s.depth()};
  }
  if (!options.translations)
    most = std::max(most, TurnSearch(depth, points).run(options.work, deadline));
  bound.depth = most * (1 - 1e-9);
  return bound;
}

/// What curves on one surface prove that pierce the other one, m; 0 if no more than `beat`.
double bound_by_crossings(const Body& probe, const Body& fixed, const Pose& X_FM, double beat,
                          const Deadline& deadline, const BoundOptions& options) {
  const CommonDepth depth(probe, fixed, X_FM);
  const Transform& X_FW = depth.X_FW();
  CrossingSearch search;
  search.beat = beat;
  search.reach = std::min(bound_tuning.reach * options.known,
                          2 * std::min(probe.mass.radius, fixed.mass.radius));
  search.work = static_cast<int>(
      std::min(2e9, bound_tuning.comparisons_of_work * static_cast<double>(options.work)));
  search.deadline = deadline;
  search.price = [&](const Vec3& x) {
    return options.translations
               ? 1
               : 1 + leverage(probe.mass.inertia, X_FW.R.transpose() * (x - X_FW.p));
  };
  return best_crossing(probe, fixed, depth.X_FM(), search).bound * (1 - 1e-9);
}

}  // namespace

std::optional<double> depth_lower_bound(const Body& probe, const Body& fixed, const Pose& X_FM,
                                        const Deadline& deadline, const BoundOptions& options) {
  const auto bound = witnessed_lower_bound(probe, fixed, X_FM, deadline, options);
  if (!bound) return std::nullopt;
  return bound->depth;
}

std::optional<LowerBound> witnessed_lower_bound(const Body& probe, const Body& fixed,
                                                const Pose& X_FM, const Deadline& deadline,
                                                const BoundOptions& options) {
  std::optional<LowerBound> bound;
  if (probe.solid || fixed.solid) bound = bound_by_points(probe, fixed, X_FM, deadline, options);
  if (bound && bound->depth >= bound_tuning.worth_crossings * options.known) return bound;
  const double crossing =
      bound_by_crossings(probe, fixed, X_FM, bound ? bound->depth : 0, deadline, options);
  if (!bound && !(crossing > 0)) return std::nullopt;
  if (!bound) bound = LowerBound{};
  bound->depth = std::max(bound->depth, crossing);
  return bound;
}

}  // namespace sonde
