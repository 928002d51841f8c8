// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "engine/body/body.hpp"
#include "engine/penetration/contact/contact_rows.hpp"
#include "engine/penetration/descent/descent.hpp"

namespace sonde {

/// Whose contacts tell where to leap: those of the outlines, or those of the bodies themselves, the
/// nearest few or many of them.
enum class Guide { outlines, few, many };

/// When a descent by leaps is good enough, or not worth going on with.
struct LeapGoal {
  Guide guide = Guide::outlines;
  double tolerance = 0.02;  ///< of |y|: steps shorter than this share of it end the descent
  int steps = 15;           ///< iterations at most
  double reach = 0.3;       ///< of |y|: the length of the first leap at most
  /// m: stopped where the contacts near by say that it will not end below. 0: never.
  double beat = 0;
};

/// Local optimisation for a search, where only the end counts: from a free pose towards the point
/// nearest to the origin that the contacts near by allow, and there, if that is free, at once; else
/// a part of the way. What lies between is not looked at, which is what makes it quick. Each pose
/// on the way is free (by overlap with doubt as contact), whatever the outlines are like.
class LeapDescent {
 public:
  LeapDescent(const Body& probe, const Body& fixed, Method method);

  /// Adds the times of phases to `times` from now on; null: to nothing.
  void time_into(PhaseTimes* times) noexcept;
  /// Keeps all of its poses in a subspace (ContactRows::stay_within), where runs are to begin.
  void stay_within(const Mat6& onto);
  /// From the free pose at y in the chart of the device pose. Its contacts, and the residual that
  /// they leave, are of meaning where it was guided by the bodies' own.
  Descent::Outcome run(const Chart& chart, const Vec6& y, const LeapGoal& goal,
                       const Deadline& deadline);

  bool is_free(const Chart& chart, const Vec6& y) const;
  /// From the free pose at y straight towards the origin, by bisection: a nearer free pose, or y.
  Vec6 pull_in(const Chart& chart, const Vec6& y, const Deadline& deadline = {}) const;

  /// Leaps so far that were cut short since there was no room for more rows, or what was in the way
  /// had been thought over often enough. None makes an end converged: it is so by rows that hold
  /// it.
  int limited() const { return limited_; }

 private:
  struct Pace;
  ContactRows& rows(Guide guide);
  /// Towards the nearest point of the rows, as far as it is free; false where no part of it is, or
  /// where there was no time to find one.
  bool leap(const Chart& chart, const LeastDistance& nearest, double margin, ContactRows& rows,
            Pace& pace, Vec6& y, const Deadline& deadline);
  /// A free leap round what is in the way of the first, by rows of all that is (ContactRows::cut).
  std::optional<Vec6> detour(const Chart& chart, const Vec6& first, double margin,
                             ContactRows& rows, double trust, const Vec6& y,
                             const Deadline& deadline);

  const Body& probe_;
  const Body& fixed_;
  Method method_;
  std::optional<Mat6> onto_;
  PhaseTimes* times_ = nullptr;
  int limited_ = 0;
  std::array<std::optional<ContactRows>, 3> rows_;  // made when first asked for
};

}  // namespace sonde
