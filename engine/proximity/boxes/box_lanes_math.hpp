// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernels over the boxes of a node are written in; for their sources alone.
#pragma once

#include <cstdint>

#include "engine/body/tree.hpp"
#include "engine/proximity/boxes/box_lanes.hpp"
#include "engine/simd/instruction_set.hpp"
#include "engine/simd/vectors.hpp"

// What kernels are made of must be inlined into each of them, to be compiled for its instruction
// set; by reference, because vectors wider than the plain ones have no common way of being passed.
#define SONDE_INLINE __attribute__((always_inline)) inline

namespace sonde {

static_assert(Tree::width == 16, "a lane for each box of a node");
using Floats = FloatX16;
using Ints = IntX16;

struct Vectors {
  Floats x, y, z;
};

SONDE_INLINE void load(const float* p, Floats& out) { __builtin_memcpy(&out, p, sizeof out); }
SONDE_INLINE void store(const Floats& x, float* out) { __builtin_memcpy(out, &x, sizeof x); }
SONDE_INLINE void magnitude(const Floats& x, Floats& out) {
  const Ints bits = reinterpret_cast<Ints>(x) & 0x7fffffff;
  out = reinterpret_cast<Floats>(bits);
}
SONDE_INLINE void larger(const Floats& x, const Floats& y, Floats& out) { out = x > y ? x : y; }
SONDE_INLINE void square_root(const Floats& x, Floats& out) {
  for (std::uint32_t k = 0; k < Tree::width; ++k) out[k] = __builtin_sqrtf(x[k]);
}
SONDE_INLINE void dot(const Vectors& a, const float (&b)[3], Floats& out) {
  out = a.x * b[0] + a.y * b[1] + a.z * b[2];
}
SONDE_INLINE void dot(const Vectors& a, const Vectors& b, Floats& out) {
  out = a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The boxes of a node, lengths times the scale, centres from the origin.
struct Boxes {
  Vectors center;
  Floats half[3];
  Vectors axis[3];
};

SONDE_INLINE void load(const Tree::Node& node, float scale, const float (&origin)[3], Boxes& b) {
  load(node.center[0], b.center.x);
  load(node.center[1], b.center.y);
  load(node.center[2], b.center.z);
  b.center.x = b.center.x * scale - origin[0];
  b.center.y = b.center.y * scale - origin[1];
  b.center.z = b.center.z * scale - origin[2];
  for (int i = 0; i < 3; ++i) {
    load(node.half[i], b.half[i]);
    b.half[i] *= scale;
  }
  for (int i = 0; i < 2; ++i) {
    load(node.axis[i][0], b.axis[i].x);
    load(node.axis[i][1], b.axis[i].y);
    load(node.axis[i][2], b.axis[i].z);
  }
  const Vectors &u = b.axis[0], &v = b.axis[1];
  b.axis[2] = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/// What rounding can do to lengths made of the way d between the centres, the sides of a node's
/// boxes and those of another box (half their sum: other).
SONDE_INLINE void rounding(const Vectors& d, const Boxes& b, float other, Floats& out) {
  Floats x, y, z;
  magnitude(d.x, x), magnitude(d.y, y), magnitude(d.z, z);
  out =
      (x + y + z + (b.half[0] + b.half[1] + b.half[2]) + other) * static_cast<float>(box_rounding);
}

}  // namespace sonde
