// SPDX-License-Identifier: GPL-3.0-or-later
// Rejects compiler options with which the same input would give other bits than elsewhere: see
// packaging/cmake/SondeOptions.cmake.
#include <Eigen/Core>
#include <cfloat>

#if defined EIGEN_VECTORIZE_FMA || defined __ARM_FEATURE_FMA
#error "Eigen contracts products and sums here, against the rule of the same bits everywhere"
#endif
#ifdef EIGEN_VECTORIZE_AVX
#error "Eigen sums four at a time here: in another order than elsewhere"
#endif
#ifdef __FAST_MATH__
#error "-ffast-math breaks the rule of the same bits everywhere"
#endif
static_assert(FLT_EVAL_METHOD == 0, "doubles must be rounded to doubles: on 32-bit x86, use SSE2");
