// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/fourier.hpp"

#include <cstddef>
#include <numbers>

#include "engine/base/elementary.hpp"

namespace sonde {
namespace {

using Complex = std::complex<double>;

/// Without the standard's handling of infinities, which calls the compiler's library.
Complex product(const Complex& a, const Complex& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

std::size_t smallest_factor(std::size_t n) {
  for (std::size_t p = 2; p * p <= n; ++p)
    if (n % p == 0) return p;
  return n;
}

class FourierSum {
 public:
  FourierSum(const std::vector<double>& x, const std::vector<Complex>& roots)
      : x_(x), roots_(roots) {}

  /// Transforms n values from index `first` on, `stride` apart.
  void run(std::size_t first, std::size_t n, std::size_t stride, Complex* out) const {
    if (n == 1) {
      *out = x_[first];
      return;
    }
    const std::size_t p = smallest_factor(n), m = n / p;
    for (std::size_t r = 0; r < p; ++r) run(first + r * stride, m, stride * p, out + r * m);
    std::vector<Complex> part(p);
    for (std::size_t k = 0; k < m; ++k) {
      for (std::size_t r = 0; r < p; ++r) part[r] = product(out[r * m + k], roots_[r * k * stride]);
      for (std::size_t q = 0; q < p; ++q) {
        Complex sum = part[0];
        for (std::size_t r = 1; r < p; ++r) sum += product(part[r], roots_[q * r % p * m * stride]);
        out[q * m + k] = sum;
      }
    }
  }

 private:
  const std::vector<double>& x_;
  const std::vector<Complex>& roots_;
};

}  // namespace

FourierTransform::FourierTransform(std::size_t n) {
  for (std::size_t k = 0; k < n; ++k)
    roots_.push_back(elementary::polar(
        1, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n)));
}

std::vector<Complex> FourierTransform::operator()(const std::vector<double>& x) const {
  std::vector<Complex> out(x.size());
  if (!x.empty()) FourierSum(x, roots_).run(0, x.size(), 1, out.data());
  return out;
}

std::vector<Complex> fourier_transform(const std::vector<double>& x) {
  return FourierTransform(x.size())(x);
}

}  // namespace sonde
