// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sonde::generate {
namespace {

std::uint32_t count_of(const std::vector<Vec3>& points) {
  return static_cast<std::uint32_t>(points.size());
}

void add_quad(Soup& soup, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  soup.triangles.push_back({a, b, c});
  soup.triangles.push_back({a, c, d});
}

std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

double to_unit(std::uint64_t bits) { return static_cast<double>(bits >> 11U) * 0x1p-53; }

/// The value of the noise at a lattice point, -1 to 1.
double lattice(std::int64_t i, std::int64_t j, std::int64_t k, std::uint64_t seed) {
  std::uint64_t h = mix(seed ^ static_cast<std::uint64_t>(i));
  h = mix(h ^ static_cast<std::uint64_t>(j));
  h = mix(h ^ static_cast<std::uint64_t>(k));
  return 2 * to_unit(h) - 1;
}

}  // namespace

Soup loft(const std::vector<Ring>& rings, Ends ends, const Vec3& first, const Vec3& last) {
  Soup soup;
  const auto n = static_cast<std::uint32_t>(rings.front().size());
  const auto count = static_cast<std::uint32_t>(rings.size());
  for (const Ring& ring : rings)
    soup.vertices.insert(soup.vertices.end(), ring.begin(), ring.end());
  const std::uint32_t bands = ends == Ends::joined ? count : count - 1;
  for (std::uint32_t r = 0; r < bands; ++r) {
    const std::uint32_t here = r * n;
    const std::uint32_t next = (r + 1) % count * n;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      add_quad(soup, here + i, here + j, next + j, next + i);
    }
  }
  if (ends != Ends::capped) return soup;
  const std::uint32_t south = count_of(soup.vertices);
  const std::uint32_t top = (count - 1) * n;
  soup.vertices.push_back(first);
  soup.vertices.push_back(last);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    soup.triangles.push_back({south, j, i});
    soup.triangles.push_back({south + 1, top + i, top + j});
  }
  return soup;
}

Soup wrapped_grid(int n, int m, const std::function<Vec3(double u, double v)>& point) {
  std::vector<Ring> rings;
  for (int i = 0; i < n; ++i) {
    Ring ring;
    for (int j = 0; j < m; ++j) ring.push_back(point(two_pi * i / n, two_pi * j / m));
    rings.push_back(std::move(ring));
  }
  return loft(rings, Ends::joined);
}

Soup torus(double major, double minor, int major_steps, int minor_steps) {
  return wrapped_grid(major_steps, minor_steps, [&](double u, double v) {
    const double r = major + minor * std::cos(v);
    // The rings advance along +u, so that v runs anticlockwise about that direction downwards.
    return Vec3(r * std::cos(u), r * std::sin(u), -minor * std::sin(v));
  });
}

Soup icosphere(int levels) {
  const double phi = std::numbers::phi;
  Soup soup;
  soup.vertices = {{-1, phi, 0}, {1, phi, 0}, {-1, -phi, 0}, {1, -phi, 0},
                   {0, -1, phi}, {0, 1, phi}, {0, -1, -phi}, {0, 1, -phi},
                   {phi, 0, -1}, {phi, 0, 1}, {-phi, 0, -1}, {-phi, 0, 1}};
  for (Vec3& x : soup.vertices) x.normalize();
  soup.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                    {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                    {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                    {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, fresh] = middles.try_emplace(std::minmax(a, b), count_of(soup.vertices));
      if (fresh) soup.vertices.push_back((soup.vertices[a] + soup.vertices[b]).normalized());
      return found->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : soup.triangles) {
      const std::uint32_t a = middle(t[0], t[1]);
      const std::uint32_t b = middle(t[1], t[2]);
      const std::uint32_t c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    soup.triangles = std::move(finer);
  }
  return soup;
}

Ring at_height(const Outline& outline, double z) {
  Ring ring;
  ring.reserve(outline.size());
  for (const Point2& p : outline) ring.emplace_back(p.x, p.y, z);
  return ring;
}

Outline resample(const Outline& line, int count) {
  std::vector<double> along = {0};
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() +
                    std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y));
  Outline out;
  std::size_t i = 0;
  for (int k = 0; k < count; ++k) {
    const double s = along.back() * k / (count - 1);
    while (i + 2 < line.size() && along[i + 1] < s) ++i;
    const double f = (s - along[i]) / (along[i + 1] - along[i]);
    out.push_back(
        {line[i].x + f * (line[i + 1].x - line[i].x), line[i].y + f * (line[i + 1].y - line[i].y)});
  }
  return out;
}

void add_arc(Outline& line, Point2 center, double radius, double from, double to, int steps) {
  for (int i = 0; i <= steps; ++i) {
    const double a = from + (to - from) * i / steps;
    line.push_back({center.x + radius * std::cos(a), center.y + radius * std::sin(a)});
  }
}

void append(Soup& a, const Soup& b) {
  const std::uint32_t base = count_of(a.vertices);
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

Soup compacted(const Soup& soup) {
  constexpr std::uint32_t unused = 0xffffffffU;
  std::vector<std::uint32_t> renumbered(soup.vertices.size(), unused);
  Soup out;
  for (const Triangle& t : soup.triangles) {
    Triangle fresh{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (renumbered[t[k]] == unused) {
        renumbered[t[k]] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(soup.vertices[t[k]]);
      }
      fresh[k] = renumbered[t[k]];
    }
    out.triangles.push_back(fresh);
  }
  return out;
}

double smooth_step(double a, double b, double x) {
  const double s = std::min(1.0, std::max(0.0, (x - a) / (b - a)));
  return s * s * s * (s * (6 * s - 15) + 10);
}

double Random::uniform(double low, double high) {
  const double unit = to_unit(mix(state_));
  state_ += 0x9e3779b97f4a7c15U;
  return low + (high - low) * unit;
}

double noise(const Vec3& x, std::uint64_t seed) {
  const Vec3 floor = x.array().floor();
  const auto i = static_cast<std::int64_t>(floor.x());
  const auto j = static_cast<std::int64_t>(floor.y());
  const auto k = static_cast<std::int64_t>(floor.z());
  const Vec3 f = x - floor;
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int a = corner & 1, b = (corner >> 1) & 1, c = corner >> 2;
    const double weight = (a ? smooth_step(0, 1, f.x()) : 1 - smooth_step(0, 1, f.x())) *
                          (b ? smooth_step(0, 1, f.y()) : 1 - smooth_step(0, 1, f.y())) *
                          (c ? smooth_step(0, 1, f.z()) : 1 - smooth_step(0, 1, f.z()));
    sum += weight * lattice(i + a, j + b, k + c, seed);
  }
  return sum;
}

double fractal_noise(const Vec3& x, int octaves, double gain, std::uint64_t seed) {
  double sum = 0;
  double height = 1;
  double frequency = 1;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += height * noise(frequency * x, seed + static_cast<std::uint64_t>(octave));
    height *= gain;
    frequency *= 2;
  }
  return sum;
}

}  // namespace sonde::generate
