// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/boxes/box_lanes.hpp"

#include "engine/proximity/boxes/box_lanes_math.hpp"

namespace sonde {
namespace {

/// Gaps and projections between one box and boxes of a node.
template <class Floats>
struct Outside {
  Floats in_a[3], in_b[3];  ///< the gaps along the axes of a and of b
  Floats d_a[3], d_b[3];    ///< |projections| of the vector between the centres
  Floats dd;                ///< square of its length
  Floats rounding;
};

template <class Floats>
SONDE_INLINE void compare(const PlacedBox& a, const Boxes<Floats>& b, Outside<Floats>& o) {
  const Floats dx = a.center[0] - b.center.x, dy = a.center[1] - b.center.y,
               dz = a.center[2] - b.center.z;
  o.dd = dx * dx + dy * dy + dz * dz;
  rounding(Vectors<Floats>{dx, dy, dz}, b, a.half[0] + a.half[1] + a.half[2], o.rounding);
  for (int i = 0; i < 3; ++i) {
    const Floats along = dx * a.axis[i][0] + dy * a.axis[i][1] + dz * a.axis[i][2];
    magnitude(along, o.d_a[i]);
    o.in_a[i] = o.d_a[i] - a.half[i];
  }
  for (int j = 0; j < 3; ++j) {
    const Floats along = dx * b.axis[j].x + dy * b.axis[j].y + dz * b.axis[j].z;
    magnitude(along, o.d_b[j]);
    o.in_b[j] = o.d_b[j] - b.half[j];
    for (int i = 0; i < 3; ++i) {
      const Floats cosine =
          b.axis[j].x * a.axis[i][0] + b.axis[j].y * a.axis[i][1] + b.axis[j].z * a.axis[i][2];
      Floats c;
      magnitude(cosine, c);
      o.in_a[i] -= b.half[j] * c;
      o.in_b[j] -= a.half[i] * c;
    }
  }
}

template <class Floats>
SONDE_INLINE void sum_of_outer_squares(const Floats (&gap)[3], Floats& out) {
  const Floats zero{};
  Floats p[3];
  for (int i = 0; i < 3; ++i) larger(gap[i], zero, p[i]);
  out = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

template <class Floats>
SONDE_INLINE void distances_of(const PlacedBox& box, const Tree::Node& node, std::uint32_t first,
                               float scale, Lanes& out) {
  Boxes<Floats> b;
  load(node, first, scale, box.origin, b);
  Outside<Floats> o;
  compare(box, b, o);
  Floats in_a, in_b, squared, faces;
  sum_of_outer_squares(o.in_a, in_a);
  sum_of_outer_squares(o.in_b, in_b);
  larger(in_a, in_b, squared);
  square_root(squared, faces);
  // Along the vector d between the centres: |d| − Σ hᵢ |d·aᵢ| / |d| over the axes of both boxes.
  Floats reach = box.half[0] * o.d_a[0] + b.half[0] * o.d_b[0];
  for (int i = 1; i < 3; ++i) reach += box.half[i] * o.d_a[i] + b.half[i] * o.d_b[i];
  Floats length;
  square_root(o.dd, length);
  const Floats room = o.dd - reach;
  const Floats none{};
  const Floats centers = room > 0 ? room / (length + 1e-30f) : none;
  Floats best;
  larger(faces, centers, best);
  Floats along = (box.center[0] - b.center.x) * box.direction[0] +
                 (box.center[1] - b.center.y) * box.direction[1] +
                 (box.center[2] - b.center.z) * box.direction[2];
  for (int i = 0; i < 3; ++i) {
    const Floats cosine = b.axis[i].x * box.direction[0] + b.axis[i].y * box.direction[1] +
                          b.axis[i].z * box.direction[2];
    Floats c;
    magnitude(cosine, c);
    along -= b.half[i] * c;
    along -= box.half[i] *
             __builtin_fabsf(box.axis[i][0] * box.direction[0] + box.axis[i][1] * box.direction[1] +
                             box.axis[i][2] * box.direction[2]);
  }
  larger(best, along, best);
  Floats depth = o.in_a[0];
  for (int i = 1; i < 3; ++i) larger(depth, o.in_a[i], depth);
  for (const Floats& gap : o.in_b) larger(depth, gap, depth);
  best = best > o.rounding ? best - o.rounding : depth - o.rounding;
  store(best, out.value + first);
}

template <class Floats>
SONDE_INLINE void gaps_of(const PlacedBox& box, const Tree::Node& node, std::uint32_t first,
                          float scale, Lanes& out) {
  Boxes<Floats> b;
  load(node, first, scale, box.origin, b);
  Outside<Floats> o;
  compare(box, b, o);
  Floats best = o.in_a[0];
  for (int i = 1; i < 3; ++i) larger(best, o.in_a[i], best);
  for (const Floats& gap : o.in_b) larger(best, gap, best);
  store(best - o.rounding, out.value + first);
}

/// Subtracts from a gap along an axis the amount by which the motion `shift` can reduce it. `d` and
/// `shift` are projections on the axis; the sign of `d` says on which side the gap is.
template <class Floats>
SONDE_INLINE void lose(const Floats& d, const Floats& shift, Floats& gap) {
  const Floats none{};
  const Floats closing = d > 0 ? -shift : shift;
  gap -= closing > 0 ? closing : none;
}

template <class Floats>
SONDE_INLINE void gaps_shifted_of(const PlacedBox& box, const Tree::Node& node, std::uint32_t first,
                                  float scale, Lanes& out) {
  Boxes<Floats> b;
  load(node, first, scale, box.origin, b);
  Outside<Floats> o;
  compare(box, b, o);
  const Floats dx = box.center[0] - b.center.x, dy = box.center[1] - b.center.y,
               dz = box.center[2] - b.center.z;
  const float(&w)[3] = box.shift;
  Floats best;
  for (int i = 0; i < 3; ++i) {
    const Floats along = dx * box.axis[i][0] + dy * box.axis[i][1] + dz * box.axis[i][2];
    const float shift = w[0] * box.axis[i][0] + w[1] * box.axis[i][1] + w[2] * box.axis[i][2];
    lose(along, Floats{} + shift, o.in_a[i]);
    if (i == 0)
      best = o.in_a[0];
    else
      larger(best, o.in_a[i], best);
  }
  for (int j = 0; j < 3; ++j) {
    const Vectors<Floats>& axis = b.axis[j];
    const Floats along = dx * axis.x + dy * axis.y + dz * axis.z;
    const Floats shift = w[0] * axis.x + w[1] * axis.y + w[2] * axis.z;
    lose(along, shift, o.in_b[j]);
    larger(best, o.in_b[j], best);
  }
  const float size = __builtin_fabsf(w[0]) + __builtin_fabsf(w[1]) + __builtin_fabsf(w[2]);
  store(best - (o.rounding + size * static_cast<float>(box_rounding)), out.value + first);
}

template <class Floats>
SONDE_INLINE void point_distances_of(const PlacedPoint& point, const Tree::Node& node,
                                     std::uint32_t first, float scale, Lanes& out) {
  Boxes<Floats> b;
  load(node, first, scale, point.origin, b);
  const Floats dx = point.rest[0] - b.center.x, dy = point.rest[1] - b.center.y,
               dz = point.rest[2] - b.center.z;
  Floats gap[3];
  for (int i = 0; i < 3; ++i) {
    const Floats along = dx * b.axis[i].x + dy * b.axis[i].y + dz * b.axis[i].z;
    Floats size;
    magnitude(along, size);
    gap[i] = size - b.half[i];
  }
  Floats squared, best, off;
  sum_of_outer_squares(gap, squared);
  square_root(squared, best);
  rounding(Vectors<Floats>{dx, dy, dz}, b, 0, off);
  store(best - off, out.value + first);
}

/// Separating axes of a ray and a box: the box's normals, which separate the start of the ray, and
/// the cross products of its normals with the ray.
template <class Floats>
SONDE_INLINE void ray_gaps_of(const PlacedRay& ray, const Tree::Node& node, std::uint32_t first,
                              float scale, Lanes& out) {
  Boxes<Floats> b;
  load(node, first, scale, ray.from.origin, b);
  const Floats dx = ray.from.rest[0] - b.center.x, dy = ray.from.rest[1] - b.center.y,
               dz = ray.from.rest[2] - b.center.z;
  Floats m[3], d[3], size[3];
  for (int i = 0; i < 3; ++i) {
    m[i] = dx * b.axis[i].x + dy * b.axis[i].y + dz * b.axis[i].z;
    d[i] = ray.direction[0] * b.axis[i].x + ray.direction[1] * b.axis[i].y +
           ray.direction[2] * b.axis[i].z;
    magnitude(d[i], size[i]);
  }
  Floats best = b.half[0] * -1;
  for (int i = 0; i < 3; ++i) {
    Floats off;
    magnitude(m[i], off);
    const Floats behind = m[i] * d[i] > 0 ? off - b.half[i] : best;
    larger(best, behind, best);
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const Floats moment = m[j] * d[k] - m[k] * d[j];
    Floats beside;
    magnitude(moment, beside);
    beside -= b.half[j] * size[k] + b.half[k] * size[j];
    larger(best, beside, best);
  }
  Floats lost;
  rounding(Vectors<Floats>{dx, dy, dz}, b, 0, lost);
  store(best - lost, out.value + first);
}

// A macro cannot put an attribute or a name in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define SONDE_BOX_KERNEL(NAME, WHAT, PLACED, FLOATS, ATTRIBUTE)                                 \
  ATTRIBUTE void NAME(const PLACED& a, const Tree::Node& b, float scale, Lanes& out) {          \
    std::uint32_t first = 0;                                                                    \
    for (; is_used(b, first); first += lanes_of<FLOATS>) WHAT<FLOATS>(a, b, first, scale, out); \
    for (; first < Tree::width; ++first) out.value[first] = 0;                                  \
  }
#define SONDE_BOX_KERNELS(NAME, FLOATS, ATTRIBUTE)                             \
  namespace NAME {                                                             \
  SONDE_BOX_KERNEL(distances, distances_of, PlacedBox, FLOATS, ATTRIBUTE)      \
  SONDE_BOX_KERNEL(gaps, gaps_of, PlacedBox, FLOATS, ATTRIBUTE)                \
  SONDE_BOX_KERNEL(shifted, gaps_shifted_of, PlacedBox, FLOATS, ATTRIBUTE)     \
  SONDE_BOX_KERNEL(points, point_distances_of, PlacedPoint, FLOATS, ATTRIBUTE) \
  SONDE_BOX_KERNEL(rays, ray_gaps_of, PlacedRay, FLOATS, ATTRIBUTE)            \
  constexpr BoxKernels kernels{distances, gaps, shifted, points, rays};        \
  }

// NOLINTEND(bugprone-macro-parentheses)
SONDE_BOX_KERNELS(plain, FloatX4, )
#if defined(__x86_64__)
SONDE_BOX_KERNELS(avx2, FloatX8, __attribute__((target(SONDE_TARGET_AVX2))))
SONDE_BOX_KERNELS(avx512, FloatX16, __attribute__((target(SONDE_TARGET_AVX512))))
constexpr BoxKernels all[] = {plain::kernels, avx2::kernels, avx512::kernels};
#else
constexpr BoxKernels all[] = {plain::kernels};
#endif

}  // namespace

std::span<const BoxKernels> all_box_kernels() {
  return {all, static_cast<std::size_t>(instruction_set()) + 1};
}

const BoxKernels& box_kernels() { return all_box_kernels().back(); }

}  // namespace sonde
