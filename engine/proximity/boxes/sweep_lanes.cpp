// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/proximity/boxes/sweep_lanes.hpp"

#include "engine/proximity/boxes/box_lanes_math.hpp"

namespace sonde {
namespace {

SONDE_INLINE void cross(const float (&a)[3], const float (&b)[3], float (&out)[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}
SONDE_INLINE float dot(const float (&a)[3], const float (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The longest time that a gap along one of the axes offered so far is certain to last.
template <class Floats>
struct Longest {
  Floats acceleration;  // at least slightly positive
  Floats least_gap;     // the clearance plus the rounding error
  Floats step{};

  /// `along`: projection on the axis of the vector from the standing box's centre to the moving
  /// one's; `reach`: sum of the boxes' half extents on the axis; `speed`: projection of the moving
  /// centre's velocity; `turning`: upper bound of how much faster than its centre a point of the
  /// moving box approaches.
  SONDE_INLINE void offer(const Floats& along, const Floats& reach, const Floats& speed,
                          const Floats& turning, const PathBounds& path) {
    Floats distance;
    magnitude(along, distance);
    const Floats gap = distance - reach - least_gap;
    const Floats v = (along < 0 ? -speed : speed) - turning - path.speed_rounding;
    // The root of gap + v x − ½ acceleration x², in the form without cancellation.
    const Floats none{};
    const Floats slack = gap > 0 ? gap : none;
    Floats root;
    square_root(v * v + 2 * acceleration * slack, root);
    const Floats top = v < 0 ? 2 * slack : v + root;
    const Floats bottom = v < 0 ? root - v : acceleration;
    const Floats lasts = gap > 0 ? top / bottom : none;
    larger(step, lasts, step);
  }
};

constexpr float least = 1e-30f;
constexpr float rounded_up = 1 + 0x1p-18f;
constexpr float rounded_down = 1 - 0x1p-18f;

template <class Floats>
SONDE_INLINE void box_moves(const PlacedBox& a, const PlacedVelocity& velocity,
                            const PathBounds& path, const Tree::Node& node, std::uint32_t first,
                            float scale, Lanes& out) {
  Boxes<Floats> b;
  load(node, first, scale, a.origin, b);
  const Vectors<Floats> d{a.center[0] - b.center.x, a.center[1] - b.center.y,
                          a.center[2] - b.center.z};
  float v[3], spin[3][3];  // velocity of the centre, and of the axes' tips relative to it
  cross(velocity.angular, a.center, v);
  float arm2 = 0, half2 = 0;
  for (int k = 0; k < 3; ++k) {
    v[k] += velocity.at_origin[k];
    arm2 += (a.center[k] - path.com[k]) * (a.center[k] - path.com[k]);
    half2 += a.half[k] * a.half[k];
    cross(velocity.angular, a.axis[k], spin[k]);
  }
  const float radius = __builtin_sqrtf(arm2) + __builtin_sqrtf(half2);
  const Floats zero{};
  Longest<Floats> longest{zero + (path.acceleration * radius * rounded_up + least), zero};
  rounding(d, b, a.half[0] + a.half[1] + a.half[2], longest.least_gap);
  longest.least_gap += path.clearance;
  Floats reach_b[3];
  for (int j = 0; j < 3; ++j) reach_b[j] = b.half[j];
  for (int i = 0; i < 3; ++i) {
    Floats along, reach = zero + a.half[i];
    dot(d, a.axis[i], along);
    for (int j = 0; j < 3; ++j) {
      Floats cosine, c;
      dot(b.axis[j], a.axis[i], cosine);
      magnitude(cosine, c);
      reach += b.half[j] * c;
      reach_b[j] += a.half[i] * c;
    }
    float turning = 0;
    for (int k = 0; k < 3; ++k) turning += a.half[k] * __builtin_fabsf(dot(a.axis[i], spin[k]));
    longest.offer(along, reach, zero + dot(a.axis[i], v), zero + turning, path);
  }
  for (int j = 0; j < 3; ++j) {
    Floats along, speed, turning = zero;
    dot(d, b.axis[j], along);
    dot(b.axis[j], v, speed);
    for (int i = 0; i < 3; ++i) {
      Floats tip, size;
      dot(b.axis[j], spin[i], tip);
      magnitude(tip, size);
      turning += a.half[i] * size;
    }
    longest.offer(along, reach_b[j], speed, turning, path);
  }
  store(longest.step * rounded_down, out.value + first);
}

template <class Floats>
SONDE_INLINE void node_moves(const PlacedBox& b, const PlacedVelocity& velocity,
                             const PathBounds& path, const Tree::Node& node, std::uint32_t first,
                             float scale, Lanes& out) {
  Boxes<Floats> a;
  load(node, first, scale, b.origin, a);
  const Vectors<Floats> d{a.center.x - b.center[0], a.center.y - b.center[1],
                          a.center.z - b.center[2]};
  const float(&w)[3] = velocity.angular;
  const Vectors<Floats> v{velocity.at_origin[0] + (w[1] * a.center.z - w[2] * a.center.y),
                          velocity.at_origin[1] + (w[2] * a.center.x - w[0] * a.center.z),
                          velocity.at_origin[2] + (w[0] * a.center.y - w[1] * a.center.x)};
  const Vectors<Floats> arm{a.center.x - path.com[0], a.center.y - path.com[1],
                            a.center.z - path.com[2]};
  Floats arm2, arm_length, half_length;
  dot(arm, arm, arm2);
  square_root(arm2, arm_length);
  square_root(a.half[0] * a.half[0] + a.half[1] * a.half[1] + a.half[2] * a.half[2], half_length);
  const Floats zero{};
  Longest<Floats> longest{(arm_length + half_length) * (path.acceleration * rounded_up) + least,
                          zero};
  rounding(d, a, b.half[0] + b.half[1] + b.half[2], longest.least_gap);
  longest.least_gap += path.clearance;
  Floats reach_a[3], about[3];  // about[j]: angular speed of the body about axis j
  for (int j = 0; j < 3; ++j) {
    reach_a[j] = a.half[j];
    Floats turn;
    dot(a.axis[j], w, turn);
    magnitude(turn, about[j]);
  }
  for (int i = 0; i < 3; ++i) {
    float across[3];  // n × ω: n·(ω × r) = (n × ω)·r
    cross(b.axis[i], w, across);
    Floats along, speed, reach = zero + b.half[i], turning = zero;
    dot(d, b.axis[i], along);
    dot(v, b.axis[i], speed);
    for (int j = 0; j < 3; ++j) {
      Floats cosine, c, tip, size;
      dot(a.axis[j], b.axis[i], cosine);
      magnitude(cosine, c);
      reach += a.half[j] * c;
      reach_a[j] += b.half[i] * c;
      dot(a.axis[j], across, tip);
      magnitude(tip, size);
      turning += a.half[j] * size;
    }
    longest.offer(along, reach, speed, turning, path);
  }
  for (int j = 0; j < 3; ++j) {
    const int k = (j + 1) % 3, l = (j + 2) % 3;
    Floats along, speed;
    dot(d, a.axis[j], along);
    dot(v, a.axis[j], speed);
    // For its own axes, (aⱼ × ω)·aₖ is the angular velocity about the third axis.
    longest.offer(along, reach_a[j], speed, a.half[k] * about[l] + a.half[l] * about[k], path);
  }
  store(longest.step * rounded_down, out.value + first);
}

// A macro cannot put an attribute or a name in parentheses.
// NOLINTBEGIN(bugprone-macro-parentheses)
#define SONDE_SWEEP_KERNEL(NAME, WHAT, FLOATS, ATTRIBUTE)                                    \
  ATTRIBUTE void NAME(const PlacedBox& box, const PlacedVelocity& v, const PathBounds& path, \
                      const Tree::Node& node, float scale, Lanes& out) {                     \
    std::uint32_t first = 0;                                                                 \
    for (; is_used(node, first); first += lanes_of<FLOATS>)                                  \
      WHAT<FLOATS>(box, v, path, node, first, scale, out);                                   \
    for (; first < Tree::width; ++first) out.value[first] = 0;                               \
  }
#define SONDE_SWEEP_KERNELS(NAME, FLOATS, ATTRIBUTE)      \
  namespace NAME {                                        \
  SONDE_SWEEP_KERNEL(one, box_moves, FLOATS, ATTRIBUTE)   \
  SONDE_SWEEP_KERNEL(many, node_moves, FLOATS, ATTRIBUTE) \
  constexpr SweepKernels sweeps{one, many};               \
  }

// NOLINTEND(bugprone-macro-parentheses)
SONDE_SWEEP_KERNELS(plain, FloatX4, )
#if defined(__x86_64__)
SONDE_SWEEP_KERNELS(avx2, FloatX8, __attribute__((target(SONDE_TARGET_AVX2))))
SONDE_SWEEP_KERNELS(avx512, FloatX16, __attribute__((target(SONDE_TARGET_AVX512))))
constexpr SweepKernels all_sweeps[] = {plain::sweeps, avx2::sweeps, avx512::sweeps};
#else
constexpr SweepKernels all_sweeps[] = {plain::sweeps};
#endif

}  // namespace

std::span<const SweepKernels> all_sweep_kernels() {
  return {all_sweeps, static_cast<std::size_t>(instruction_set()) + 1};
}

const SweepKernels& sweep_kernels() { return all_sweep_kernels().back(); }

}  // namespace sonde
