// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

#include "engine/geometry/pose.hpp"
#include "tests/engine/devices/loaded_standin.hpp"

namespace sonde::test {

/// One maker's library, and how its stand-in says things.
struct Maker {
  const char* name;
  const char* variable;
  const char* library;
  const char* path;
  double unit;  ///< of the library, in m
  int too_fast;
  int up;  ///< the library's axis that points up

  /// Ours (x right, y away, z up; m) in the library's axes and unit.
  Vec3 place(const Vec3& p) const {
    return up == 2 ? Vec3(Vec3(-p.y(), p.x(), p.z()) / unit)
                   : Vec3(Vec3(p.x(), p.z(), -p.y()) / unit);
  }
  /// The force that the library was given, in our axes; N.
  Vec3 force(const LoadedStandin& standin) const {
    const Vec3 f = standin.force();
    return up == 2 ? Vec3(f.y(), -f.x(), f.z()) : Vec3(f.x(), -f.z(), f.y());
  }
};
inline constexpr Maker force_dimension{"libdhd", "SONDE_LIBDHD", STANDIN_DHD, "libdhd/0", 1, 2, 2};
inline constexpr Maker three_d{"libHD", "SONDE_LIBHD", STANDIN_HD, "libHD/Default Device",
                               1e-3,    0x0203,        1};

inline void forget_makers() {
  for (const char* name : {"SONDE_LIBDHD", "SONDE_LIBHD", "SONDE_HD_DEVICES"}) ::unsetenv(name);
}

}  // namespace sonde::test
