// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks of the kernels over the boxes of a node; include it only in their sources.
#pragma once

#include <cstdint>

#include "engine/body/tree.hpp"
#include "engine/proximity/boxes/box_lanes.hpp"
#include "engine/simd/instruction_set.hpp"
#include "engine/simd/vectors.hpp"

// The building blocks must be inlined into each kernel, to be compiled for its instruction set.
// They take references, because vectors wider than the plain ones have no common calling
// convention.
#define SONDE_INLINE __attribute__((always_inline)) inline

namespace sonde {

/// Number of boxes of a node that one vector holds.
template <class Floats>
constexpr std::uint32_t lanes_of = sizeof(Floats) / sizeof(float);
template <class Floats>
struct IntsOf;
template <>
struct IntsOf<FloatX4> {
  using type = IntX4;
};
template <>
struct IntsOf<FloatX8> {
  using type = IntX8;
};
template <>
struct IntsOf<FloatX16> {
  using type = IntX16;
};

template <class Floats>
struct Vectors {
  Floats x, y, z;
};

template <class Floats>
SONDE_INLINE void load(const float* p, Floats& out) {
  __builtin_memcpy(&out, p, sizeof out);
}
template <class Floats>
SONDE_INLINE void store(const Floats& x, float* out) {
  __builtin_memcpy(out, &x, sizeof x);
}
template <class Floats>
SONDE_INLINE void magnitude(const Floats& x, Floats& out) {
  using Ints = typename IntsOf<Floats>::type;
  const Ints bits = reinterpret_cast<Ints>(x) & 0x7fffffff;
  out = reinterpret_cast<Floats>(bits);
}
template <class Floats>
SONDE_INLINE void larger(const Floats& x, const Floats& y, Floats& out) {
  out = x > y ? x : y;
}
/// Through memory: compilers turn a loop over numbers there into one instruction.
template <class Floats>
SONDE_INLINE void square_root(const Floats& x, Floats& out) {
  float each[lanes_of<Floats>];
  store(x, each);
  for (float& number : each) number = __builtin_sqrtf(number);
  load(each, out);
}
template <class Floats>
SONDE_INLINE void dot(const Vectors<Floats>& a, const float (&b)[3], Floats& out) {
  out = a.x * b[0] + a.y * b[1] + a.z * b[2];
}
template <class Floats>
SONDE_INLINE void dot(const Vectors<Floats>& a, const Vectors<Floats>& b, Floats& out) {
  out = a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Boxes of a node: lengths times the scale, centres relative to the origin.
template <class Floats>
struct Boxes {
  Vectors<Floats> center;
  Floats half[3];
  Vectors<Floats> axis[3];
};

/// Loads the boxes from lane `first` on.
template <class Floats>
SONDE_INLINE void load(const Tree::Node& node, std::uint32_t first, float scale,
                       const float (&origin)[3], Boxes<Floats>& b) {
  load(node.center[0] + first, b.center.x);
  load(node.center[1] + first, b.center.y);
  load(node.center[2] + first, b.center.z);
  b.center.x = b.center.x * scale - origin[0];
  b.center.y = b.center.y * scale - origin[1];
  b.center.z = b.center.z * scale - origin[2];
  for (int i = 0; i < 3; ++i) {
    load(node.half[i] + first, b.half[i]);
    b.half[i] *= scale;
  }
  for (int i = 0; i < 2; ++i) {
    load(node.axis[i][0] + first, b.axis[i].x);
    load(node.axis[i][1] + first, b.axis[i].y);
    load(node.axis[i][2] + first, b.axis[i].z);
  }
  const Vectors<Floats>&u = b.axis[0], &v = b.axis[1];
  b.axis[2] = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// Whether lane `first` is used. Unused lanes follow the used ones.
SONDE_INLINE bool is_used(const Tree::Node& node, std::uint32_t first) {
  return first < Tree::width && node.child[first] != Tree::none;
}

/// The rounding error of lengths made of the vector d between the centres, the sides of a node's
/// boxes and those of another box (`other`: half the sum of its sides).
template <class Floats>
SONDE_INLINE void rounding(const Vectors<Floats>& d, const Boxes<Floats>& b, float other,
                           Floats& out) {
  Floats x, y, z;
  magnitude(d.x, x), magnitude(d.y, y), magnitude(d.z, z);
  out =
      (x + y + z + (b.half[0] + b.half[1] + b.half[2]) + other) * static_cast<float>(box_rounding);
}

}  // namespace sonde
