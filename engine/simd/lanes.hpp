// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of doubles, by the vector extensions of GCC and Clang. Each element is a lane. A source
// defines SONDE_LANES, the number of lanes, before it includes this header: 8 (AVX-512), 4 (AVX2)
// or 2 (the baseline of the build: SSE2, NEON). Code between SONDE_LANES_BEGIN and SONDE_LANES_END
// is compiled for these instructions, so it may run only on a processor that has them. All of it is
// in an unnamed namespace, and it must not use inline functions of other headers: the linker keeps
// one copy of such a function for the whole program, and that could be the one compiled for
// AVX-512.
#pragma once

#ifndef SONDE_LANES
#error "SONDE_LANES is not defined"
#endif

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "engine/simd/instruction_set.hpp"

// FMA is left out on purpose: the same operations, rounded alike, give the same bits everywhere.
#if SONDE_LANES == 8
#define SONDE_LANES_TARGET SONDE_TARGET_AVX512
#else
#define SONDE_LANES_TARGET SONDE_TARGET_AVX2
#endif
#define SONDE_LANES_PRAGMA(text) _Pragma(#text)
#if !defined(__x86_64__) || SONDE_LANES == 2
#define SONDE_LANES_BEGIN
#define SONDE_LANES_END
#elif defined(__clang__)
#define SONDE_LANES_PUSH(target_name) \
  SONDE_LANES_PRAGMA(                 \
      clang attribute push(__attribute__((target(target_name))), apply_to = function))
#define SONDE_LANES_BEGIN SONDE_LANES_PUSH(SONDE_LANES_TARGET)
#define SONDE_LANES_END _Pragma("clang attribute pop")
#else
#define SONDE_LANES_PUSH(target_name) \
  _Pragma("GCC push_options") SONDE_LANES_PRAGMA(GCC target(target_name))
#define SONDE_LANES_BEGIN SONDE_LANES_PUSH(SONDE_LANES_TARGET)
#define SONDE_LANES_END _Pragma("GCC pop_options")
#endif

SONDE_LANES_BEGIN
namespace sonde::lanes {
namespace {

/// A number in each lane.
typedef double Number __attribute__((vector_size(SONDE_LANES * sizeof(double))));
/// A truth value in each lane: all bits are set, or none.
typedef long long Mask __attribute__((vector_size(SONDE_LANES * sizeof(double))));

/// A Number with x in every lane.
inline Number broadcast(double x) { return x - Number{}; }
/// A Number with 0, 1, 2 and so on in its lanes.
inline Number lane_numbers() {
  Number x;
  for (int i = 0; i < SONDE_LANES; ++i) x[i] = i;
  return x;
}
inline Number load(const double* p) {
  Number x;
  __builtin_memcpy(&x, p, sizeof x);
  return x;
}
inline void store(double* p, Number x) { __builtin_memcpy(p, &x, sizeof x); }

inline Number select(Mask m, Number yes, Number no) { return m ? yes : no; }

// smaller, larger and root act lane by lane. The processor's minimum and maximum equal x < y ? x :
// y and x > y ? x : y to the bit, and its square root is rounded correctly. Compilers seldom choose
// these instructions by themselves. any() is true if a lane is true. (g++ 12 warns of the AVX-512
// forms without a mask.)
#if !defined(__x86_64__)
inline Number smaller(Number x, Number y) { return x < y ? x : y; }
inline Number larger(Number x, Number y) { return x > y ? x : y; }
inline Number root(Number x) {
  for (int i = 0; i < SONDE_LANES; ++i) x[i] = __builtin_sqrt(x[i]);
  return x;
}
inline bool any(Mask m) { return (m[0] | m[1]) != 0; }
#elif SONDE_LANES == 8
inline Number smaller(Number x, Number y) { return _mm512_maskz_min_pd(0xff, x, y); }
inline Number larger(Number x, Number y) { return _mm512_maskz_max_pd(0xff, x, y); }
inline Number root(Number x) { return _mm512_maskz_sqrt_pd(0xff, x); }
inline bool any(Mask m) { return _mm512_movepi64_mask(reinterpret_cast<__m512i>(m)) != 0; }
#elif SONDE_LANES == 4
inline Number smaller(Number x, Number y) { return _mm256_min_pd(x, y); }
inline Number larger(Number x, Number y) { return _mm256_max_pd(x, y); }
inline Number root(Number x) { return _mm256_sqrt_pd(x); }
inline bool any(Mask m) { return _mm256_movemask_pd(reinterpret_cast<__m256d>(m)) != 0; }
#else
inline Number smaller(Number x, Number y) { return _mm_min_pd(x, y); }
inline Number larger(Number x, Number y) { return _mm_max_pd(x, y); }
inline Number root(Number x) { return _mm_sqrt_pd(x); }
inline bool any(Mask m) { return _mm_movemask_pd(reinterpret_cast<__m128d>(m)) != 0; }
#endif
/// x limited to the range 0 to 1, lane by lane.
inline Number clamp01(Number x) { return smaller(larger(x, Number{}), broadcast(1)); }

/// A vector in each lane.
struct Vector {
  Number x, y, z;
};
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(Number s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// Arrays of vectors have the layout [coordinate][lane]. Both functions act on SONDE_LANES lanes
// from lane `first` on.
inline Vector load(const double in[3][8], int first) {
  return {load(in[0] + first), load(in[1] + first), load(in[2] + first)};
}
inline void store(double out[3][8], int first, const Vector& x) {
  store(out[0] + first, x.x);
  store(out[1] + first, x.y);
  store(out[2] + first, x.z);
}
inline Vector select(Mask m, const Vector& yes, const Vector& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

}  // namespace
}  // namespace sonde::lanes
SONDE_LANES_END
