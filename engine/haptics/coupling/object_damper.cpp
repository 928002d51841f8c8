// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/object_damper.hpp"

#include <Eigen/Cholesky>
#include <array>

#include "engine/geometry/rotation.hpp"

namespace sonde {
namespace {

/// How y follows the device while contacts stay as they are: of_y ẏ = −of_device V.
struct HeldContacts {
  std::array<Vec6, ContactSet::capacity> rows;  ///< J of each loaded contact
  int size = 0;
  Eigen::LDLT<Mat6> of_y;
  Mat6 of_device = Mat6::Zero();

  Vec6 rate(const Vec6& velocity) const { return -of_y.solve(of_device * velocity); }
};

/// Removes from a torque the axes about which a turn moves no mass; y does not contain them either.
void leave_free_axes_out(const Chart& chart, Eigen::Ref<Vec3> torque) {
  for (int i = 0; i < 3; ++i) {
    if (chart.mass().inertia[i] > 0) continue;
    const Vec3 axis = chart.principal() * Vec3::Unit(i);
    torque -= axis * axis.dot(torque);
  }
}

/// None if no contact carries a load.
HeldContacts held_contacts(const MassProperties& mass, Method method,
                           const Separation& separation) {
  constexpr double faint = 1e-3;  // of the load
  Chart chart(mass, separation.device);
  chart.absorb_free_spin(separation.separated);
  const Vec6 y = chart.coordinates(separation.separated);
  const Vec3 com = separation.separated * mass.com;
  HeldContacts out;
  // A contact persists if J ẏ = −G V, with J the derivative of its gap by y, and G that by the
  // device's motion if the separated pose moves with the device.
  Mat6 of_y = Mat6::Zero();
  double load = 0;
  for (const Contact& contact : separation.contacts) {
    if (!(contact.multiplier > 0)) continue;
    Vec6 J = chart.row(y, contact.on_probe, contact.normal), G;
    G << contact.normal, (contact.on_probe - com).cross(contact.normal);
    leave_free_axes_out(chart, G.tail<3>());
    if (method == Method::pdt) {  // no turn, no torque
      J.head<3>().setZero();
      G.tail<3>().setZero();
    }
    of_y += contact.multiplier * J * J.transpose();
    out.of_device += contact.multiplier * J * G.transpose();
    load += contact.multiplier * J.squaredNorm();
    out.rows[static_cast<std::size_t>(out.size++)] = J;
  }
  of_y.diagonal().array() += faint * load;
  if (out.size > 0) out.of_y.compute(of_y);
  return out;
}

}  // namespace

Mat6 separation_jacobian(const MassProperties& mass, Method method,
                         const Separation& separation) noexcept {
  const HeldContacts held = held_contacts(mass, method, separation);
  if (held.size == 0) return Mat6::Zero();
  return -held.of_y.solve(held.of_device);
}

Wrench object_damper(const MassProperties& mass, Method method, const Separation& separation,
                     const Pose& before, double dt, const Coupling& coupling) noexcept {
  const HeldContacts held = held_contacts(mass, method, separation);
  if (held.size == 0) return {};
  const Pose& device = separation.device;
  Vec6 velocity;
  velocity << (device * mass.com - before * mass.com) / dt,
      rotation_vector(device.q * before.q.conjugate()) / dt;
  // The wrench −b Yᵀ ẏ is b Σ λ (J·per_load) G over the contacts, that of the spring k Σ λ G.
  const Vec6 per_load = held.of_y.solve(held.rate(velocity));
  double b = coupling.b_t;
  for (int i = 0; i < held.size; ++i) {
    const double pull = -held.rows[static_cast<std::size_t>(i)].dot(per_load);
    if (b * pull > coupling.k) b = coupling.k / pull;
  }
  const Vec6 wrench = b * (held.of_device.transpose() * per_load);
  Wrench out;
  out.force = wrench.head<3>();
  out.torque = wrench.tail<3>();
  return out;
}

}  // namespace sonde
