// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace sonde {

/// Σ x[n] e^(−2πi nk/N) for k = 0 to N − 1, for any N; fast if N has small factors (Cooley and
/// Tukey, 1965). The same bits everywhere, which Eigen's FFT does not guarantee.
std::vector<std::complex<double>> fourier_transform(const std::vector<double>& x);

/// The same of several signals of one length, whose roots of unity are computed once.
class FourierTransform {
 public:
  explicit FourierTransform(std::size_t n);
  /// `x` has n values.
  std::vector<std::complex<double>> operator()(const std::vector<double>& x) const;

 private:
  std::vector<std::complex<double>> roots_;
};

}  // namespace sonde
