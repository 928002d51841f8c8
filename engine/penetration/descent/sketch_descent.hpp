// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {

/// The descent of a search on the sketches of two bodies: some points of each keep out of the
/// distance field of the other. A whole descent costs about as much as one gather of the bodies'
/// contacts, so many can be made; where they end is where the true ones are worth making.
class SketchDescent {
 public:
  SketchDescent(const Sketch& probe, const Sketch& fixed, const MassProperties& fixed_mass);

  /// Adds the times of descents to `times` from now on; null: to nothing.
  void time_into(PhaseTimes* times) noexcept { times_ = times; }
  /// By few points: none lies deeper than `deepest`, m. Those that lay too deep when last asked are
  /// looked at first.
  bool is_free(const Chart& chart, const Vec6& y, double deepest = 0);

  /// m: how far the deepest of more points lies in the other body at y; 0 where none does.
  double depth_of_points(const Chart& chart, const Vec6& y);

  struct End {
    Vec6 y;
    double gap = 0;  ///< m, the least that is left at y; negative where points lie too deep
    int steps = 0;
    bool arrived = false;  ///< else it gave up
  };
  struct Goal {
    Method method = Method::pdg;
    bool rough = false;                                     ///< by few points
    double margin = 0;                                      ///< m: points are to be so far out
    int steps = 16;                                         ///< at most
    double beat = std::numeric_limits<double>::infinity();  ///< m: given up where it ends above
  };
  /// From y down to where |y| is least.
  End run(const Chart& chart, const Vec6& y, const Goal& goal);

  double spacing() const { return spacing_; }  ///< m: what is finer is not seen

 private:
  struct Frame;
  /// What was known of a group when it was last looked at.
  struct Known {
    double gap, seen;  ///< m: the least of its points, at least; what was travelled until then
  };
  /// A point of the probe, in its axes; a point of the other, and the way out of the body it
  /// belongs to, in the axes of that.
  struct Near {
    Quad on_probe, out;
    float gap;      // m
    bool of_probe;  // whose point it is
  };
  double find_near(const Frame& frame, double reach, bool rough);
  template <class Place, class Add>
  double find_near_in(const PointGroup& group, const DistanceField& field, Known& known,
                      double reach, const Place& place, const Add& add);
  void make_rows(const Chart& chart, const Vec6& y, const Frame& frame, Method method);
  LeastDistance solve(double margin, bool open);

  const Sketch& probe_;
  const Sketch& fixed_;
  Mat3 R_FB_;
  Vec3 com_B_;
  double spacing_;
  PhaseTimes* times_ = nullptr;
  double travelled_ = 0;
  std::vector<Known> of_probe_, of_fixed_;
  std::size_t deep_of_probe_ = 0, deep_of_fixed_ = 0;  // groups of few points
  std::vector<Near> near_;
  std::vector<HalfSpace> rows_;
  std::vector<double> at_;
};

}  // namespace sonde
