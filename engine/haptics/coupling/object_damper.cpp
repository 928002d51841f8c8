// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/object_damper.hpp"

#include <Eigen/Cholesky>

#include "engine/geometry/rotation.hpp"

namespace sonde {

Mat6 separation_jacobian(const MassProperties& mass, Method method,
                         const Separation& separation) noexcept {
  constexpr double faint = 1e-3;  // of the load
  const Chart chart(mass, separation.device);
  const Vec6 y = chart.coordinates(separation.separated);
  const Vec3 com = separation.separated * mass.com;
  // A contact stays one if J ẏ = −G V: J is how its gap changes with y, and G how it changes if the
  // separated pose goes with the device.
  Mat6 of_y = Mat6::Zero(), of_device = Mat6::Zero();
  double load = 0;
  for (const Contact& contact : separation.contacts) {
    if (!(contact.multiplier > 0)) continue;
    Vec6 J = chart.row(y, contact.on_probe, contact.normal), G;
    G << contact.normal, (contact.on_probe - com).cross(contact.normal);
    if (method == Method::pdt) {  // no turn, no torque
      J.head<3>().setZero();
      G.tail<3>().setZero();
    }
    of_y += contact.multiplier * J * J.transpose();
    of_device += contact.multiplier * J * G.transpose();
    load += contact.multiplier * J.squaredNorm();
  }
  if (!(load > 0)) return Mat6::Zero();
  of_y.diagonal().array() += faint * load;
  return -of_y.ldlt().solve(of_device);
}

Wrench object_damper(const MassProperties& mass, Method method, const Separation& separation,
                     const Pose& before, double dt, const Coupling& coupling) noexcept {
  const Pose& device = separation.device;
  Vec6 velocity;
  velocity << (device * mass.com - before * mass.com) / dt,
      rotation_vector(device.q * before.q.conjugate()) / dt;
  const Mat6 jacobian = separation_jacobian(mass, method, separation);
  const Vec6 y = Chart(mass, device).coordinates(separation.separated);
  const Vec6 rate = jacobian * velocity;
  double b = coupling.b_t;
  const double outward = -y.dot(rate) * b, spring = coupling.k * y.squaredNorm();
  if (outward > spring) b *= spring / outward;
  const Vec6 wrench = -b * (jacobian.transpose() * rate);
  Wrench out;
  out.force = wrench.head<3>();
  out.torque = wrench.tail<3>();
  return out;
}

}  // namespace sonde
