// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

namespace sonde {

/// Σ x[n] e^(−2πi nk/N) for k = 0 to N − 1, for any N; fast if N has small factors (Cooley and
/// Tukey, 1965). The same bits everywhere, which Eigen's FFT does not guarantee.
std::vector<std::complex<double>> fourier_transform(const std::vector<double>& x);

}  // namespace sonde
