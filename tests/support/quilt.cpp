// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/quilt.hpp"

#include <algorithm>

namespace sonde::test {
namespace {

/// Of a cell; less than a quarter, so that every cell stays convex and has both its diagonals.
constexpr double largest_shift = 0.24;
constexpr double sliver = 1e-4;  ///< width of a narrow cell, of a grid step

/// a where both ends agree in a coordinate: what lies on a plane of the axes stays there exactly.
Vec3 between(const Vec3& a, const Vec3& b, double share) { return a + share * (b - a); }

bool before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// The same from either end of the edge: lines are pulled towards the middle.
double sliver_cut(int i, int n) {
  if (2 * i > n) return 1 - sliver_cut(n - i, n);
  const bool pulled = i % 2 == 1 && 2 * (i + 1) <= n;
  return pulled ? (i + 1 - sliver) / n : double(i) / n;
}

}  // namespace

std::vector<double> Quilt::cuts(int n) {
  std::vector<double> out;
  for (int i = 0; i <= n; ++i) {
    const bool inner = i > 0 && i < n;
    double at = double(i) / n;
    if (inner && cutting_.kind == Cutting::Kind::random)
      at += uniform(random_, -largest_shift, largest_shift) / n;
    if (inner && cutting_.kind == Cutting::Kind::slivers) at = sliver_cut(i, n);
    out.push_back(at);
  }
  return out;
}

std::vector<Vec3> Quilt::edge(const Vec3& from, const Vec3& to, int n) {
  const bool forwards = before(from, to);
  const Vec3& low = forwards ? from : to;
  const Vec3& high = forwards ? to : from;
  auto& at = edges_[{low.x(), low.y(), low.z(), high.x(), high.y(), high.z(), double(n)}];
  if (at.empty()) at = cuts(n);
  std::vector<Vec3> out;
  for (const double share : at) out.push_back(between(low, high, share));
  out.front() = low, out.back() = high;
  if (!forwards) std::reverse(out.begin(), out.end());
  return out;
}

void Quilt::patch(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, int nu, int nv) {
  const auto low = edge(a, b, nu), high = edge(d, c, nu);
  const auto left = edge(a, d, nv), right = edge(b, c, nv);
  std::vector<std::vector<Vec3>> rows;
  for (int j = 0; j <= nv; ++j) {
    if (j == 0 || j == nv) {
      rows.push_back(j == 0 ? low : high);
      continue;
    }
    std::vector<Vec3> row = {left[static_cast<std::size_t>(j)]};
    const auto us = cuts(nu);
    for (int i = 1; i < nu; ++i) {
      const double u = us[static_cast<std::size_t>(i)];
      const double v = cuts(nv)[static_cast<std::size_t>(j)];
      row.push_back(between(between(a, b, u), between(d, c, u), v));
    }
    row.push_back(right[static_cast<std::size_t>(j)]);
    rows.push_back(row);
  }
  for (std::size_t j = 0; j + 1 < rows.size(); ++j)
    for (std::size_t i = 0; i + 1 < rows[j].size(); ++i)
      quad(rows[j][i], rows[j][i + 1], rows[j + 1][i + 1], rows[j + 1][i]);
}

void Quilt::fan(const Vec3& a, const Vec3& b, const Vec3& apex, int n) {
  const auto row = edge(a, b, n);
  for (std::size_t i = 0; i + 1 < row.size(); ++i) triangle(row[i], row[i + 1], apex);
}

void Quilt::quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const bool other_way = cutting_.kind == Cutting::Kind::random && random_() % 2 == 0;
  triangle(a, b, other_way ? d : c);
  if (other_way)
    triangle(b, c, d);
  else
    triangle(a, c, d);
}

void Quilt::triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const std::size_t at = soup_.points.size();
  soup_.points.insert(soup_.points.end(), {a, b, c});
  soup_.polygons.push_back({at, at + 1, at + 2});
}

}  // namespace sonde::test
