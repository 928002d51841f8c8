// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of single precision, by the vector extensions of GCC and Clang. Operators act lane by
// lane. A comparison sets all bits of a lane, or none. A vector must be no wider
// than those of the instruction set that its function is compiled for. The compiler splits a wider
// one, but g++ 12 does so number by number where vectors are compared: boxes took six times as
// long. Kernels over doubles use lanes.hpp instead; they are compiled once for each instruction
// set.
#pragma once

#include <cstdint>

namespace sonde {

/// Four numbers. A vector in space uses the first three.
typedef float FloatX4 __attribute__((vector_size(16)));
typedef std::int32_t IntX4 __attribute__((vector_size(16)));
typedef float FloatX8 __attribute__((vector_size(32)));
typedef std::int32_t IntX8 __attribute__((vector_size(32)));
typedef float FloatX16 __attribute__((vector_size(64)));
typedef std::int32_t IntX16 __attribute__((vector_size(64)));

}  // namespace sonde
