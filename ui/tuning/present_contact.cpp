// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/present_contact.hpp"

#include <algorithm>
#include <cmath>

#include "engine/study/stability/contact_situations.hpp"
#include "engine/study/tuning/assumptions.hpp"
#include "ui/base/format.hpp"

namespace sonde::ui {

std::string kind_of_contact(const Separation& separation) {
  const bool holds = separation.status == Status::penetrating && separation.contacts.size > 0;
  return holds ? name_of(contact_kind(separation)) : std::string();
}

namespace {

StudiedBoundary::Basis basis_of(const TuningColumn& column, double boundary) {
  using Basis = StudiedBoundary::Basis;
  const auto at = [&](const std::optional<SweepLimit>& limit) {
    return limit && limit->fault != HoldFault::none && limit->stiffness == boundary;
  };
  if (at(column.stable)) return Basis::as_is;
  return at(column.harder_knocks) ? Basis::harder_knocks : Basis::without_friction;
}

}  // namespace

std::optional<StudiedBoundary> boundary_in(const TuningResults& results, GainAxis axis,
                                           const std::string& kind, double damping) {
  std::optional<StudiedBoundary> least;
  for (const TuningLine& line : results.lines) {
    if (line.axis != axis || line.kind != kind || !line.assumed.empty() || line.columns.empty())
      continue;
    const TuningColumn& column = *std::ranges::min_element(
        line.columns, {},
        [&](const TuningColumn& each) { return std::abs(each.damping - damping); });
    const double own = boundary_that_counts(results, column);
    if (!least || own < least->stiffness) least = {own, line.hand, basis_of(column, own)};
  }
  return least;
}

QString words_of(const StudiedBoundary& boundary) {
  QString hand = QStringLiteral("a %1 hand").arg(text(boundary.hand));
  switch (boundary.basis) {
    case StudiedBoundary::Basis::without_friction:
      return hand + QStringLiteral(", without friction");
    case StudiedBoundary::Basis::harder_knocks:
      return hand + QStringLiteral(", at harder knocks");
    case StudiedBoundary::Basis::as_is:
      break;
  }
  return hand;
}

QString distance_text(double stiffness, double boundary) {
  if (!std::isfinite(boundary) || boundary <= 0 || stiffness <= 0) return {};
  return stiffness > boundary
             ? QStringLiteral("%1 times too stiff").arg(number(stiffness / boundary))
             : QStringLiteral("could be %1 times as stiff").arg(number(boundary / stiffness));
}

}  // namespace sonde::ui
