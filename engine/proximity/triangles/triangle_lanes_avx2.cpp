// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef __x86_64__
#define SONDE_LANES 4
#include "engine/proximity/triangles/triangle_lanes_kernel.hpp"
#endif
