// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/gain_sweep.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/error.hpp"
#include "engine/study/contact_stability.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

void set_gains(Coupling& c, GainAxis axis, double stiffness, double damping) {
  switch (axis) {
    case GainAxis::object:
      c.k = stiffness;
      break;
    case GainAxis::translation:
      c.k_t = stiffness;
      c.b_t = damping;
      break;
    case GainAxis::rotation:
      c.k_r = stiffness;
      c.b_r = damping;
      break;
  }
}

/// The range of an axis in its own unit.
struct Range {
  double low, high, most_damping;
};
Range range_of(const TuningSetup& setup, GainAxis axis) {
  if (axis == GainAxis::rotation) {
    const double per = setup.rotation_per_translation;
    return {setup.low * per, setup.high * per, setup.most_rotational_damping};
  }
  return {setup.low, setup.high, axis == GainAxis::object ? 0 : setup.most_damping};
}

/// The linear contact at one damping: `stiffness` at one N/m (N·m/rad) of the axis.
SampledContact linear_contact(const TuningSetup& setup, GainAxis axis, double damping) {
  const FeltStiffness& felt = setup.situation.contact.stiffness;
  Coupling own = setup.loop.coupling, others = setup.loop.coupling;
  own.k = own.k_t = own.k_r = 0;
  set_gains(own, axis, 1, 0);
  set_gains(others, axis, 0, damping);
  return {setup.loop.device, setup.loop.sample_time, felt.stiffness(own), felt.stiffness(others),
          felt.damping(others)};
}

class Columns {
 public:
  Columns(const TuningSetup& setup, GainAxis axis, bool whole, const Stop& stop)
      : setup_(setup), axis_(axis), whole_(whole), stop_(stop), range_(range_of(setup, axis)) {}

  std::string json() {
    if (range_.most_damping == 0)
      add(0);
    else if (whole_)
      add_map();
    else
      add(damping_of_theory());
    std::ranges::sort(columns_, {}, &Column::damping);
    Json out = Json::array();
    for (const Column& column : columns_) out.push_back(column.json);
    return Json{{"columns", out}}.dump();
  }

 private:
  struct Column {
    double damping, good;
    Json json;
  };
  static constexpr double jolt_share = 0.25;  ///< of the largest torque
  static constexpr std::array shares{0.0, 0.125, 0.25, 0.5, 1.0};

  double damping_of_theory() const {
    double best = 0, most = -1;
    for (const double share : shares) {
      const double damping = share * range_.most_damping;
      const double factor = largest_stable_factor(linear_contact(setup_, axis_, damping));
      if (factor > most) {
        most = factor;
        best = damping;
      }
    }
    return best;
  }

  /// The dampings of a coarse scale, then between the best of them and its neighbours.
  void add_map() {
    for (const double share : shares) add(share * range_.most_damping);
    const auto best = std::ranges::max_element(columns_, {}, &Column::good) - columns_.begin();
    std::vector<double> between;
    for (const auto other : {best - 1, best + 1})
      if (other >= 0 && other < std::ssize(columns_))
        between.push_back(
            (columns_[std::size_t(best)].damping + columns_[std::size_t(other)].damping) / 2);
    for (const double damping : between) add(damping);
  }

  void add(double damping) {
    const SampledContact contact = linear_contact(setup_, axis_, damping);
    const double theory = largest_stable_factor(contact);
    const bool known = std::isfinite(theory) && theory > 0;
    const double start = known ? theory : std::sqrt(range_.low * range_.high);
    const SweepOptions options{std::clamp(start, range_.low, range_.high), range_.low, range_.high,
                               setup_.ratio, whole_};
    const auto run = [&](double stiffness) {
      ClosedLoopSetup loop = setup_.loop;
      set_gains(loop.coupling, axis_, stiffness, damping);
      ClosedLoop closed(loop);
      return press_and_hold(closed, press());
    };
    const StiffnessSweep sweep = sweep_stiffness(run, options, stop_);
    columns_.push_back({damping, sweep.good.stiffness,
                        json_of(damping, theory, largest_passive_factor(contact), sweep)});
  }

  /// Where rotations are swept, the knock turns the probe too, about the axis that resists most.
  Press press() const {
    Press out = press_of(setup_.situation);
    if (axis_ != GainAxis::rotation) return out;
    const Mat3 felt = setup_.situation.contact.stiffness.classic.bottomRightCorner<3, 3>();
    const Eigen::SelfAdjointEigenSolver<Mat3> solver((felt + felt.transpose()) / 2);
    out.jolt.torque = jolt_share * setup_.loop.device.rotation.limit * solver.eigenvectors().col(2);
    return out;
  }

  static Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

  static Json json_of(double damping, double theory, double passive, const StiffnessSweep& sweep) {
    Json runs = Json::array();
    for (const SweepPoint& point : sweep.points) runs.push_back(json_of(point));
    return {{"damping", damping},
            {"theory_stable", number(theory)},
            {"theory_passive", number(passive)},
            {"stable", sweep.stable.stiffness},
            {"stable_ends_by", name_of(sweep.stable.fault)},
            {"good", sweep.good.stiffness},
            {"good_ends_by", name_of(sweep.good.fault)},
            {"runs", runs}};
  }

  static Json json_of(const SweepPoint& point) {
    const HoldReport& r = point.report;
    return {{"stiffness", point.stiffness},
            {"stable", r.stable},
            {"chattering", r.chattering},
            {"saturated", r.saturated},
            {"fault", name_of(fault_of(r))},
            {"growth", number(r.growth)},
            {"work", number(r.work)},
            {"chatter", r.chatter},
            {"saturation", r.saturation},
            {"force_error", number(r.force_error)},
            {"torque_error", number(r.torque_error)},
            {"depth", r.depth},
            {"contact", r.contact},
            {"force", r.force},
            {"torque", r.torque},
            {"pop_throughs", r.pop_throughs},
            {"failures", r.failures}};
  }

  const TuningSetup& setup_;
  GainAxis axis_;
  bool whole_;
  const Stop& stop_;
  Range range_;
  std::vector<Column> columns_;
};

}  // namespace

const char* name_of(GainAxis axis) {
  constexpr std::array names{"object", "translation", "rotation"};
  return names[static_cast<std::size_t>(axis)];
}

Press press_of(const TuningSituation& situation) {
  return {.X_FM = situation.contact.separation.separated, .push = situation.push};
}

void set_base_gains(TuningSetup& setup) {
  const double half = setup.situation.theory / 2;
  const double stiffness = std::isfinite(half) && half > 0 ? half : Coupling{}.k;
  Coupling& c = setup.loop.coupling;
  c.k = c.k_t = stiffness;
  c.k_r = stiffness * setup.rotation_per_translation;
  c.b_t = c.b_r = 0;
}

std::string sweep_gains(const TuningSetup& setup, GainAxis axis, bool whole, const Stop& stop) {
  return Columns(setup, axis, whole, stop).json();
}

}  // namespace sonde
