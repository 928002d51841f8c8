// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/contact_view.hpp"

#include <algorithm>

#include "engine/haptics/coupling/contact_force.hpp"
#include "ui/base/theme.hpp"

namespace sonde::ui {

ContactView::Marker::Marker(vtkRenderer& renderer, GlyphShapes& shapes)
    : on_probe{renderer, shapes, colour::probe.lighter(130)},
      on_fixed{renderer, shapes, colour::contact},
      normal{renderer, shapes, colour::contact} {}

ContactView::ContactView(vtkRenderer& renderer, GlyphShapes& shapes)
    : ring_(renderer, shapes, colour::chosen) {
  for (int i = 0; i < ContactSet::capacity; ++i)
    markers_.push_back(std::make_unique<Marker>(renderer, shapes));
}

void ContactView::draw(const Frame& frame) {
  if (frame.snapshot.separation.status != Status::penetrating) return hide();
  const ContactClusters& clusters = frame.snapshot.separation.clusters;
  double largest = 0;
  for (const ContactCluster& c : clusters) largest = std::max(largest, c.contact.multiplier);
  int shown = 0;
  ring_.hide();
  for (const ContactCluster& cluster : clusters) {
    const Contact& contact = cluster.contact;
    Marker& marker = *markers_[static_cast<std::size_t>(shown++)];
    const double of_largest = largest > 0 ? contact.multiplier / largest : 1;
    const double length = (24 + 40 * of_largest) * frame.pixel;
    marker.on_fixed.set(contact.on_fixed, 5 * frame.pixel);
    // The two points all but coincide: the smaller ball of the probe shows when they do not.
    marker.on_probe.set(contact.on_probe, 3.5 * frame.pixel);
    const Vec3 tip = contact.on_fixed + contact.normal * length;
    marker.normal.set(contact.on_fixed, tip, 1.3 * frame.pixel);
    label(tip, {}, colour::contact, {contact.on_fixed, tip});  // nothing to say, not to be covered
    if (chosen_ != 0 && cluster.id == chosen_) mark(frame, cluster);
  }
  for (int i = shown; i < ContactSet::capacity; ++i) {
    Marker& marker = *markers_[static_cast<std::size_t>(i)];
    marker.on_probe.hide();
    marker.on_fixed.hide();
    marker.normal.hide();
  }
}

void ContactView::mark(const Frame& frame, const ContactCluster& cluster) {
  const Contact& contact = cluster.contact;
  const Separation& separation = frame.snapshot.separation;
  const double newton = force_per_multiplier(frame.snapshot.wrench, separation.clusters,
                                             separation.device * frame.mass.com);
  ring_.set(contact.on_fixed, contact.normal, any_normal(contact.normal) * (14 * frame.pixel),
            ring_angle, 1.6 * frame.pixel);
  label(contact.on_fixed,
        QStringLiteral("contact %1: %2 N, gap %3")
            .arg(cluster.id)
            .arg(number(newton * contact.multiplier), frame.unit.text(contact.gap)),
        colour::chosen);
}

void ContactView::hide() {
  ring_.hide();
  for (const auto& marker : markers_) {
    marker->on_probe.hide();
    marker->on_fixed.hide();
    marker->normal.hide();
  }
}

}  // namespace sonde::ui
