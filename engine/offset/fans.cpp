// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/offset/fans.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "engine/base/elementary.hpp"
#include "engine/base/ordering.hpp"

namespace sonde {

Sets::Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

std::uint32_t Sets::of(std::uint32_t i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}

bool Sets::join(std::uint32_t a, std::uint32_t b) {
  a = of(a);
  b = of(b);
  if (a == b) return false;
  parent_[std::max(a, b)] = std::min(a, b);
  return true;
}

namespace {

/// A triangle's side, between the vertices low < high.
struct Side {
  std::uint32_t low = 0, high = 0;
  std::uint32_t triangle = 0;
  std::uint32_t corner = 0;  ///< of the triangle, where the side begins
  bool upwards = false;      ///< it begins at `low`
};

class FanFinder {
 public:
  FanFinder(const Soup& soup, double flatness)
      : soup_(soup), flatness_(flatness), corners_(3 * soup.triangles.size()) {}

  Fans find(const Progress& progress) {
    list_sides(part_of(progress, 0, 0.2));
    ordering::sort(sides_, {},
                   [](const Side& s) { return std::tuple(s.low, s.high, s.triangle, s.corner); });
    report(progress, 0.6);
    for (std::size_t begin = 0, end = 0; begin < sides_.size(); begin = end) {
      while (end < sides_.size() && sides_[end].low == sides_[begin].low &&
             sides_[end].high == sides_[begin].high)
        ++end;
      join_round_edge(begin, end);
    }
    join_at_openings();
    Fans fans = numbered();
    report(progress, 0.9);
    find_beside(fans);
    report(progress, 1);
    return fans;
  }

 private:
  const Vec3& at(std::uint32_t vertex) const { return soup_.vertices[vertex]; }
  static std::uint32_t corner_id(std::uint32_t triangle, std::uint32_t corner) {
    return 3 * triangle + corner % 3;
  }
  std::uint32_t low_end(const Side& s) const {
    return corner_id(s.triangle, s.corner + (s.upwards ? 0 : 1));
  }
  std::uint32_t high_end(const Side& s) const {
    return corner_id(s.triangle, s.corner + (s.upwards ? 1 : 0));
  }

  void list_sides(const Progress& progress) {
    sides_.reserve(3 * soup_.triangles.size());
    for_each_index(soup_.triangles.size(), progress, [&](std::size_t t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t a = soup_.triangles[t][k], b = soup_.triangles[t][(k + 1) % 3];
        sides_.push_back({std::min(a, b), std::max(a, b), std::uint32_t(t), k, a < b});
      }
    });
  }

  void join(const Side& a, const Side& b) {
    corners_.join(low_end(a), low_end(b));
    corners_.join(high_end(a), high_end(b));
  }

  void join_round_edge(std::size_t begin, std::size_t end) {
    const std::size_t n = end - begin;
    if (n == 2 && sides_[begin].upwards != sides_[begin + 1].upwards)
      return join(sides_[begin], sides_[begin + 1]);
    if (n < 2) {
      open_.push_back(begin);
      return;
    }
    // Round the edge from low to high, against the clock: a triangle that goes downwards has its
    // material after it, one that goes upwards before it. They are matched as brackets are.
    struct Turned {
      double angle;
      std::size_t side;
    };
    std::vector<Turned> round;
    for (std::size_t i = begin; i < end; ++i) round.push_back({angle_of(sides_[i]), i});
    ordering::sort(round, [&](const Turned& a, const Turned& b) {
      const bool a_opens = !sides_[a.side].upwards, b_opens = !sides_[b.side].upwards;
      return std::tuple(a.angle, a_opens, a.side) < std::tuple(b.angle, b_opens, b.side);
    });
    std::vector<std::size_t> opened;
    std::vector<bool> matched(n, false);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      const std::size_t side = round[i % n].side;
      if (matched[side - begin]) continue;
      if (!sides_[side].upwards) {
        if (i < n) opened.push_back(side);
      } else if (!opened.empty()) {
        join(sides_[opened.back()], sides_[side]);
        matched[side - begin] = matched[opened.back() - begin] = true;
        opened.pop_back();
      }
    }
    for (std::size_t i = begin; i < end; ++i)
      if (!matched[i - begin]) open_.push_back(i);
  }

  double angle_of(const Side& s) const {
    const Vec3 along = (at(s.high) - at(s.low)).normalized();
    Eigen::Index least = 0;
    along.cwiseAbs().minCoeff(&least);
    const Vec3 x = along.cross(Vec3::Unit(least)).normalized(), y = along.cross(x);
    const Vec3 third = at(soup_.triangles[s.triangle][(s.corner + 2) % 3]) - at(s.low);
    // Coincident triangles have one angle, whatever the last bits.
    constexpr double grain = 1e9;
    const double angle = std::round(elementary::atan2(third.dot(y), third.dot(x)) * grain);
    return angle >= std::round(std::numbers::pi * grain) ? -angle : angle;
  }

  /// What ends at an opening at a vertex stays together there, or the opening would grow.
  void join_at_openings() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // vertex, corner
    for (const std::size_t i : open_) {
      ends.emplace_back(sides_[i].low, low_end(sides_[i]));
      ends.emplace_back(sides_[i].high, high_end(sides_[i]));
    }
    ordering::sort(ends);
    for (std::size_t i = 1; i < ends.size(); ++i)
      if (ends[i].first == ends[i - 1].first) corners_.join(ends[i].second, ends[i - 1].second);
  }

  Fans numbered() {
    constexpr auto none = std::numeric_limits<std::uint32_t>::max();
    Fans fans;
    fans.of.resize(soup_.triangles.size());
    std::vector<std::uint32_t> number(3 * soup_.triangles.size(), none);
    for (std::uint32_t t = 0; t < fans.of.size(); ++t)
      for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t& n = number[corners_.of(corner_id(t, k))];
        if (n == none) {
          n = std::uint32_t(fans.vertex.size());
          fans.vertex.push_back(soup_.triangles[t][k]);
        }
        fans.of[t][k] = n;
      }
    return fans;
  }

  void find_beside(Fans& fans) const {
    if (open_.empty()) return;
    std::vector<std::uint32_t> ends;  // the fans at openings
    for (const std::size_t i : open_)
      for (std::uint32_t k = 0; k < 2; ++k)
        ends.push_back(fans.of[sides_[i].triangle][(sides_[i].corner + k) % 3]);
    ordering::sort(ends);
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    std::array<std::vector<std::uint32_t>, 3> along{ends, ends, ends};
    const auto place = [&](int axis) {
      return [&, axis](std::uint32_t fan) { return at(fans.vertex[fan])[axis]; };
    };
    for (int axis = 0; axis < 3; ++axis)
      ordering::sort(along.at(static_cast<std::size_t>(axis)), {}, place(axis));
    for (const std::size_t i : open_) {
      // By the axis along which fewest come into question.
      auto begin = along[0].cbegin(), end = along[0].cend();
      for (int axis = 0; axis < 3; ++axis) {
        const auto& all = along.at(static_cast<std::size_t>(axis));
        const double a = at(sides_[i].low)[axis], b = at(sides_[i].high)[axis];
        const auto from =
            std::ranges::lower_bound(all, std::min(a, b) - flatness_, {}, place(axis));
        const auto to = std::ranges::upper_bound(all, std::max(a, b) + flatness_, {}, place(axis));
        if (axis == 0 || to - from < end - begin) {
          begin = from;
          end = to;
        }
      }
      for (auto fan = begin; fan != end; ++fan)
        if (lies_on(fans.vertex[*fan], sides_[i]))
          fans.beside.emplace_back(*fan, sides_[i].triangle);
    }
    ordering::sort(fans.beside);
  }

  bool lies_on(std::uint32_t vertex, const Side& s) const {
    if (vertex == s.low || vertex == s.high) return false;
    const Vec3 edge = at(s.high) - at(s.low), x = at(vertex) - at(s.low);
    const double t = x.dot(edge) / edge.squaredNorm();
    return t > 0 && t < 1 && (x - t * edge).norm() <= flatness_;
  }

  const Soup& soup_;
  double flatness_;
  Sets corners_;
  std::vector<Side> sides_;
  std::vector<std::size_t> open_;  // of sides_: those without a neighbour
};

}  // namespace

Fans find_fans(const Soup& soup, double flatness, const Progress& progress) {
  return FanFinder(soup, flatness).find(progress);
}

std::vector<std::uint32_t> pieces_of(const Fans& fans) {
  Sets sets(fans.count());
  for (const auto& t : fans.of) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  for (const auto& [fan, triangle] : fans.beside) sets.join(fan, fans.of[triangle][0]);
  constexpr auto none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(fans.count(), none), piece;
  std::uint32_t count = 0;
  for (const auto& t : fans.of) {
    std::uint32_t& n = number[sets.of(t[0])];
    if (n == none) n = count++;
    piece.push_back(n);
  }
  return piece;
}

}  // namespace sonde
