// SPDX-License-Identifier: GPL-3.0-or-later
// The elementary functions, with the same bits on every processor. Those of the C library differ
// between systems, and on one system they are chosen by the processor (with FMA or without). These
// round correctly except for one value in some thousands, for which they return the other neighbour
// of the true value: the error is below 0.51 units in the last place (elementary_test.cpp). Results
// below 2^-1022 are rounded twice. The engine uses no others (packaging/check-style refuses them).
#pragma once

#include <complex>

namespace sonde::elementary {

/// For an angle in rad. From |x| of 2^20 on they are the C library's.
double sin(double x) noexcept;
double cos(double x) noexcept;
double tan(double x) noexcept;
/// In rad, in [-π, π]; zeros and infinities as in the C standard.
double atan2(double y, double x) noexcept;
/// In rad, in [0, π]; NaN outside [-1, 1].
double acos(double x) noexcept;

double exp(double x) noexcept;
/// exp(x) - 1, accurate for tiny x.
double expm1(double x) noexcept;
/// -∞ for 0, NaN for negative x.
double log(double x) noexcept;
/// log(1 + x), accurate for tiny x.
double log1p(double x) noexcept;
double log10(double x) noexcept;
/// x to the power y; NaN for a negative x.
double pow(double x, double y) noexcept;
/// √(x² + y²), without intermediate overflow.
double hypot(double x, double y) noexcept;

inline double size(const std::complex<double>& z) noexcept { return hypot(z.real(), z.imag()); }
/// The complex number with this absolute value and angle.
inline std::complex<double> polar(double size, double angle) noexcept {
  return {size * cos(angle), size * sin(angle)};
}

}  // namespace sonde::elementary
