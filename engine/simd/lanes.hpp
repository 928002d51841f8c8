// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles in lanes, by the vector extensions of GCC and Clang. A source says how many before it
// includes this: SONDE_LANES is 8 (AVX-512), 4 (AVX2) or 2 (what the build is for: SSE2, NEON). All
// code between SONDE_LANES_BEGIN and SONDE_LANES_END is compiled for those instructions, so it may
// run only where the processor has them. Everything is in an unnamed namespace and nothing from
// other headers may be used in between: an inline function compiled here for AVX-512 could
// otherwise be the one that the linker keeps for all.
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

/// One number in each lane.
typedef double Number __attribute__((vector_size(SONDE_LANES * sizeof(double))));
/// True or false in each lane: all bits or none.
typedef long long Mask __attribute__((vector_size(SONDE_LANES * sizeof(double))));

/// The same number in every lane.
inline Number all(double x) { return x - Number{}; }
/// 0, 1, 2 and so on.
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

// The processor's minimum and maximum are x < y ? x : y and x > y ? x : y to the bit, and its
// square root is rounded correctly, but compilers seldom see that these are meant. any: is it true
// in any lane? (The masked forms are those that g++ 12 does not warn of.)
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
/// x drawn into 0 to 1.
inline Number clamp01(Number x) { return smaller(larger(x, Number{}), all(1)); }

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
/// From lane `first` of [coordinate][lane].
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
