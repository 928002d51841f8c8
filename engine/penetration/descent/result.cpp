// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/penetration/descent/result.hpp"

#include <cmath>

#include "engine/penetration/contact/contact_clusters.hpp"

namespace sonde {

const char* fault_of(const Pose& X) noexcept {
  if (!X.p.allFinite() || !X.q.coeffs().allFinite()) return "the pose is not finite";
  // A square outside the range of normal numbers has lost some or all of its digits.
  if (!std::isnormal(X.q.squaredNorm()))
    return "the length of the pose's quaternion is 0, or beyond what can be computed with";
  return nullptr;
}

Separation failed(const Pose& device, const char* reason) noexcept {
  Separation out;
  out.status = Status::failed;
  out.reason = reason;
  out.device = out.separated = device;
  return out;
}

Separation separated_at(const Pose& device) noexcept {
  Separation out;
  out.status = Status::separated;
  out.device = out.separated = device;
  out.converged = true;
  return out;
}

Separation make_separation(const Chart& chart, const Descent::Outcome& found) noexcept {
  Separation out = separated_at(chart.device());
  out.iterations = found.iterations;
  out.converged = found.converged;
  out.limited = found.limited;
  if (found.y.squaredNorm() <= 0) return out;
  out.status = Status::penetrating;
  out.separated = chart.pose(found.y);
  out.sigma = found.y.squaredNorm();
  out.depth = found.y.norm();
  out.translation = found.y.tail<3>().norm();
  out.rotation = found.y.head<3>().norm();
  out.contacts = found.contacts;
  out.clusters = contact_clusters(found.contacts, chart.mass().radius);
  out.residual = found.residual;
  return out;
}

}  // namespace sonde
