// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of single precision, by the vector extensions of GCC and Clang: operators act on all
// lanes, comparisons give all bits or none, and the compiler splits them where the processor's are
// narrower. Kernels over doubles, compiled once for each instruction set, are written in lanes.hpp.
#pragma once

#include <cstdint>

namespace sonde {

/// Three numbers and a fourth, which may idle.
typedef float FloatX4 __attribute__((vector_size(16)));
typedef std::int32_t IntX4 __attribute__((vector_size(16)));
/// A number for each box of a node (Tree::width).
typedef float FloatX16 __attribute__((vector_size(64)));
typedef std::int32_t IntX16 __attribute__((vector_size(64)));

}  // namespace sonde
