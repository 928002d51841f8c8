// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "engine/body/tree.hpp"

namespace sonde {

/// A box in the frame of the boxes that it is compared with, lengths times `scale`. If the boxes
/// lie far from the frame's own origin, compared with their size, coordinates are relative to
/// `origin`, so that rounding depends on the boxes' size only.
struct PlacedBox {
  float origin[3] = {0, 0, 0};
  float center[3];   ///< relative to origin
  float axis[3][3];  ///< axis[i]: unit, to rounding
  float half[3];
  /// A direction, from the boxes of the node to this one, that may separate them better than the
  /// face normals: unit to rounding, or zero for none.
  float direction[3] = {0, 0, 0};
  /// Its straight displacement from here, relative to the boxes of the node.
  float shift[3] = {0, 0, 0};
};

/// A point, or a ray from it, in the same frame and unit: at origin + rest.
struct PlacedPoint {
  float origin[3];
  float rest[3];
};
struct PlacedRay {
  PlacedPoint from;
  float direction[3];  ///< unit, to rounding
};

/// Sixteen values, one for each box of a node. Those of unused lanes are meaningless.
struct alignas(64) Lanes {
  float value[Tree::width];
};

/// The used lanes of a node in which the value is at most the limit: bit k for lane k.
inline std::uint32_t at_most(const Lanes& x, float limit, const Tree::Node& node) {
  std::uint32_t within = 0;
#ifdef __SSE2__
  const __m128 most = _mm_set1_ps(limit);
  const __m128i none = _mm_set1_epi32(-1);
  for (std::uint32_t k = 0; k < Tree::width; k += 4) {
    const __m128 low = _mm_cmple_ps(_mm_load_ps(x.value + k), most);
    const __m128i child = _mm_load_si128(reinterpret_cast<const __m128i*>(node.child + k));
    const __m128 unused = _mm_castsi128_ps(_mm_cmpeq_epi32(child, none));
    within |= static_cast<std::uint32_t>(_mm_movemask_ps(_mm_andnot_ps(unused, low))) << k;
  }
#else
  for (std::uint32_t k = 0; k < Tree::width && node.child[k] != Tree::none; ++k)
    within |= static_cast<std::uint32_t>(x.value[k] <= limit) << k;
#endif
  return within;
}

/// Comparisons of one object with the sixteen boxes of a node, lengths of the node times `scale` (a
/// scale that makes all compared lengths of the order of 1 keeps squares within single precision).
/// The results are reduced by the rounding error of a pair of boxes: box_rounding × (distance of
/// their centres + half the sums of their sides), m × scale. The caller must allow for the rounding
/// of the placed object's own coordinates.
struct BoxKernels {
  /// Lower bounds of the distances: by the axes of both boxes, along the line of the centres, and
  /// along the given direction. Where boxes overlap: as `gaps`.
  void (*distances)(const PlacedBox& box, const Tree::Node& node, float scale, Lanes& out);
  /// The largest gap along the six face normals (negative if they overlap along all).
  void (*gaps)(const PlacedBox& box, const Tree::Node& node, float scale, Lanes& out);
  /// The same, valid along the whole displacement `shift` of the placed box.
  void (*gaps_shifted)(const PlacedBox& box, const Tree::Node& node, float scale, Lanes& out);
  /// Lower bounds of the distances of a point.
  void (*point_distances)(const PlacedPoint& point, const Tree::Node& node, float scale,
                          Lanes& out);
  /// Lower bounds of the gap between the ray and the box along each axis that could separate them:
  /// positive if the ray misses the box.
  void (*ray_gaps)(const PlacedRay& ray, const Tree::Node& node, float scale, Lanes& out);
};

/// About thirty operations lie between the data and a result. No intermediate value exceeds the
/// data's size, and each operation rounds by 2⁻²⁴ of that; rotations are off by a few times as
/// much.
constexpr double box_rounding = 128 * 0x1p-24;
/// Bound of the loss by underflow, for sizes of the order of 1.
constexpr float underflow_guard = 1e-30f;

/// The kernels for the widest vectors of this processor.
const BoxKernels& box_kernels();

/// All kernels that this processor can run, the plain ones first. They give the same bits.
std::span<const BoxKernels> all_box_kernels();

}  // namespace sonde
