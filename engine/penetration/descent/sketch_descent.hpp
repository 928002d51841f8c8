// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "engine/geometry/chart.hpp"
#include "engine/penetration/contact/least_distance.hpp"
#include "engine/penetration/contact/separation.hpp"
#include "engine/proximity/sketch/sketch.hpp"

namespace sonde {

/// Local optimisation on the sketches of two bodies, for a search: the sketch points of each body
/// must stay outside the distance field of the other. A whole descent costs about as much as one
/// gather of the bodies' contacts, so a search can make many. It starts descents on the bodies
/// themselves only from the best end poses.
class SketchDescent {
 public:
  SketchDescent(const Sketch& probe, const Sketch& fixed, const MassProperties& fixed_mass);

  /// From now on, adds the time spent on descents to `times`. Null: records no times.
  void time_into(PhaseTimes* times) noexcept { times_ = times; }
  /// Whether none of the sketches' `few` points lies deeper than `deepest`, m, in the other body.
  /// Tests the group that failed in the last call first.
  bool is_free(const Chart& chart, const Vec6& y, double deepest = 0);

  /// m: depth at y of the deepest of all sketch points in the other body; 0 if none lies inside.
  double depth_of_points(const Chart& chart, const Vec6& y);

  struct End {
    Vec6 y;
    double gap = 0;  ///< m: least gap at y; negative where points lie too deep
    int steps = 0;
    bool arrived = false;  ///< false: the run gave up
  };
  struct Goal {
    Method method = Method::pdg;
    bool rough = false;                                     ///< use the few points only
    double margin = 0;                                      ///< m: the gap that points must keep
    int steps = 16;                                         ///< maximum number
    double beat = std::numeric_limits<double>::infinity();  ///< m: gives up if it will end above
  };
  /// Descends from y to a local minimum of |y|.
  End run(const Chart& chart, const Vec6& y, const Goal& goal);

  double spacing() const { return spacing_; }  ///< m: grid spacing; finer details are not resolved

 private:
  struct Frame;
  /// Result of the last examination of a group.
  struct Known {
    double gap, seen;  ///< m: lower bound of its gaps; travelled_ at that time
  };
  /// A point of the probe in the probe's frame, and the outward gradient of the field at the
  /// contact, in the frame of the body that has the field.
  struct Near {
    Quad on_probe, out;
    float gap;      // m
    bool of_probe;  // the point belongs to the probe's sketch
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
