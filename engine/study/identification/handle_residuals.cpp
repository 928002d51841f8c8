// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/identification/handle_residuals.hpp"

#include <algorithm>
#include <cmath>

namespace sonde {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using P = HandleParameter;

/// Uses absolute values: so a parameter of zero lies inside the range, not at its end.
FreeHandle handle_of(const VectorXd& p, const HandleScale& scale) {
  return {.inertia = std::max(std::abs(p[P::inertia]), 1e-6) * scale[P::inertia],
          .damping = std::abs(p[P::damping]) * scale[P::damping],
          .friction = std::abs(p[P::friction]) * scale[P::friction],
          .delay = std::abs(p[P::delay]) * scale[P::delay],
          .offset = p[P::offset] * scale[P::offset]};
}

}  // namespace

Index measured_size(const AxisResponse& r, const PulseWindow& w) {
  return static_cast<Index>(measured_in(r, w));
}

VectorXd measured_within(const AxisResponse& r, const std::vector<double>& of,
                         const PulseWindow& w) {
  VectorXd out(measured_size(r, w));
  Index at = 0;
  for (std::size_t k = w.begin; k < w.end; ++k)
    if (r.measured(k)) out[at++] = of[k];
  return out;
}

double motion_rms(const AxisResponse& response, const std::vector<PulseWindow>& windows) {
  double squares = 0, samples = 0;
  for (const PulseWindow& w : windows) {
    squares += without_mean(measured_within(response, response.positions, w)).squaredNorm();
    samples += static_cast<double>(measured_in(response, w));
  }
  return std::sqrt(squares / samples);
}

VectorXd without_mean(const VectorXd& x) { return x.array() - x.mean(); }

std::vector<double> modelled_motion(const FreeHandle& handle, const AxisResponse& r,
                                    std::span<const double> early) {
  std::vector<double> out;
  out.reserve(r.times.size());
  for (std::size_t part = 0; part <= r.at_rest.size(); ++part) {
    const std::size_t begin = part == 0 ? 0 : r.at_rest[part - 1];
    const std::size_t end = part == r.at_rest.size() ? r.times.size() : r.at_rest[part];
    const std::span times(r.times), commands(r.commands);
    const auto motion =
        free_motion(handle, times.subspan(begin, end - begin), commands.subspan(begin, end - begin),
                    early.empty() ? early : early.subspan(begin, end - begin));
    out.insert(out.end(), motion.begin(), motion.end());
  }
  return out;
}

int HandleResiduals::inputs() const { return static_cast<int>(P::count + std::ssize(changes)); }

int HandleResiduals::values() const {
  std::size_t n = changes.size();
  for (const PulseWindow& w : *windows) n += measured_in(*response, w);
  return static_cast<int>(n);
}

std::vector<double> HandleResiduals::modelled_by(const VectorXd& p) const {
  std::vector<double> early(changes.empty() ? 0 : response->times.size(), 0);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const std::size_t k = changes[i];
    const double share = p[P::count + static_cast<Index>(i)];
    early[k] = std::clamp(share, -0.5, 1.5) * (response->times[k] - response->times[k - 1]);
  }
  return modelled_motion(handle_of(p, scale), *response, early);
}

int HandleResiduals::operator()(const VectorXd& p, VectorXd& out) const {
  report(progress, done);
  const std::vector<double> modelled = modelled_by(p);
  Index at = 0;
  for (const PulseWindow& w : *windows) {
    const VectorXd left = without_mean(measured_within(*response, response->positions, w) -
                                       measured_within(*response, modelled, w));
    out.segment(at, left.size()) = left / unit;
    at += left.size();
  }
  for (Index i = P::count; i < p.size(); ++i) out[at++] = prior * p[i];
  return 0;
}

VectorXd HandleResiduals::at(const VectorXd& p) const {
  VectorXd out(values());
  (*this)(p, out);
  return out;
}

}  // namespace sonde
