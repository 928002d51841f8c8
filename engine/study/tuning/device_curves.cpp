// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/device_curves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "engine/base/elementary.hpp"
#include "engine/study/tuning/gain_recommendation.hpp"
#include "engine/study/tuning/tuning.hpp"
#include "engine/study/tuning/wall_hardness.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using Complex = std::complex<double>;

constexpr int points = 25;

std::vector<double> evenly_by_ratio(double from, double to) {
  std::vector<double> out;
  out.reserve(points);
  for (int i = 0; i < points; ++i)
    out.push_back(from * elementary::pow(to / from, i / (points - 1.0)));
  return out;
}

using AxisAt = std::function<SampledAxis(double)>;

std::vector<LimitAt> limits_over(const std::vector<double>& values, const AxisAt& axis_at) {
  std::vector<LimitAt> out;
  for (const double value : values) {
    const auto passive = [&](double at) { return largest_passive_stiffness(axis_at(at)); };
    constexpr double step = 1.001;
    const double less = passive(value / step), more = passive(value * step);
    const double slope =
        less > 0 && more > 0 ? elementary::log(more / less) / (2 * elementary::log(step)) : 0;
    out.push_back({value, largest_stable_stiffness(axis_at(value)), passive(value), slope});
  }
  return out;
}

struct Kind {
  const char* name;
  const char *stiffness, *damping, *step;  ///< units
  SampledAxis axis;
  double most_damping, resolution, friction;
};

std::vector<Kind> kinds_of(const TuningResults& results) {
  const auto value = [&](const char* key) {
    const auto found = results.device.find(key);
    return found == results.device.end() ? 0 : found->second;
  };
  std::vector<Kind> out;
  const auto add = [&](Kind kind) {
    if (kind.axis.inertia > 0) out.push_back(kind);
  };
  add({"translation",
       "N/m",
       "N·s/m",
       "m",
       {value("mass"), value("damping"), 0, results.sample_time, value("delay")},
       value("max_damping"),
       value("resolution"),
       value("friction")});
  if (value("max_torque") > 0)
    add({"rotation",
         "N·m/rad",
         "N·m·s/rad",
         "rad",
         {value("inertia"), value("rotational_damping"), 0, results.sample_time, value("delay")},
         value("max_rotational_damping"),
         value("rotational_resolution"),
         value("rotational_friction")});
  return out;
}

std::string row(std::initializer_list<double> numbers) {
  std::string out;
  for (const double x : numbers) out.append(1, ',').append(number_text(x));
  return out.append(1, '\n');
}

ChartAxis log_axis(const std::string& label) {
  ChartAxis axis;
  axis.label = label;
  axis.logarithmic = true;
  return axis;
}

/// Logarithmic axes cannot show zero.
template <class Point, class Of>
ChartSeries series_of(const char* name, const std::vector<Point>& all, double Point::*x,
                      const Of& y) {
  ChartSeries out{name};
  for (const Point& p : all)
    if (p.*x > 0 && y(p) > 0) {
      out.x.push_back(p.*x);
      out.y.push_back(y(p));
    }
  return out;
}

void add_z_width(const Kind& kind, DeviceCurves& out) {
  const auto points_of = z_width(kind.axis, kind.most_damping);
  for (const ZWidthPoint& p : points_of)
    out.csv.append(kind.name).append(row({p.damping, p.stable, p.passive}));
  ChartPanel panel{std::string(kind.name) + ": stable and passive below the lines",
                   log_axis(std::string("virtual damping, ") + kind.damping),
                   log_axis(std::string("stiffness, ") + kind.stiffness),
                   {},
                   {},
                   {}};
  panel.series.push_back(series_of("classic, stable", points_of, &ZWidthPoint::damping,
                                   [](const ZWidthPoint& p) { return p.stable; }));
  panel.series.push_back(series_of("classic, passive", points_of, &ZWidthPoint::damping,
                                   [](const ZWidthPoint& p) { return p.passive; }));
  // The object norm has no damping, so its stiffness is one level over the whole width.
  const auto level = [&](const char* name, double stiffness) {
    if (!(stiffness > 0) || !(kind.most_damping > 0)) return;
    panel.series.push_back({name,
                            {points_of[1].damping, kind.most_damping},
                            {stiffness, stiffness},
                            ChartSeries::Form::dashed});
  };
  level("object norm, stable", points_of.front().stable);
  level("object norm, passive", points_of.front().passive);
  out.chart.panels.push_back(panel);
}

void add_limits(const Kind& kind, DeviceCurves& out) {
  const auto add = [&](const char* what, const std::string& unit,
                       const std::vector<LimitAt>& limits) {
    for (const LimitAt& l : limits)
      out.csv.append(kind.name).append(1, ',').append(what).append(
          row({l.value, l.stable, l.passive, l.slope}));
    ChartPanel panel{std::string(kind.name) + ": limit by " + what,
                     log_axis(std::string(what) + ", " + unit),
                     log_axis(std::string("stiffness, ") + kind.stiffness),
                     {},
                     {},
                     {}};
    panel.series.push_back(
        series_of("stable", limits, &LimitAt::value, [](const LimitAt& l) { return l.stable; }));
    panel.series.push_back(
        series_of("passive", limits, &LimitAt::value, [](const LimitAt& l) { return l.passive; }));
    out.chart.panels.push_back(panel);
  };
  add("delay", "s", limits_by_delay(kind.axis));
  add("rate", "Hz", limits_by_rate(kind.axis));
  add("hand damping", kind.damping, limits_by_hand_damping(kind.axis));
  if (kind.resolution > 0 && kind.friction > 0)
    add("encoder step", kind.step, limits_by_step(kind.axis, kind.resolution, kind.friction));
}

void add_impedance(const Kind& kind, double stiffness, double damping, DeviceCurves& out) {
  SampledAxis axis = kind.axis;
  axis.virtual_damping = damping;
  ChartPanel panel{
      std::string(kind.name) + ": impedance at " + number_text(stiffness, 3) + ' ' + kind.stiffness,
      log_axis("frequency, Hz"),
      log_axis(std::string("|Z|, ") + kind.damping),
      {{"wanted"}, {"rendered"}, {"handle alone"}},
      {},
      {}};
  for (const double hertz : evenly_by_ratio(1, 0.45 / axis.sample_time)) {
    const double omega = 2 * std::numbers::pi * hertz;
    const Complex wanted = wanted_impedance(stiffness, damping, omega);
    const Complex rendered = rendered_impedance(axis, stiffness, omega);
    const Complex handle(axis.damping, axis.inertia * omega);
    out.csv.append(kind.name).append(row({hertz, wanted.real(), wanted.imag(), rendered.real(),
                                          rendered.imag(), handle.real(), handle.imag()}));
    const double sizes[] = {elementary::size(wanted), elementary::size(rendered),
                            elementary::size(handle)};
    for (std::size_t i = 0; i < 3; ++i) {
      panel.series[i].x.push_back(hertz);
      panel.series[i].y.push_back(sizes[i]);
    }
  }
  out.chart.panels.push_back(panel);
}

/// The light hand; for a rotation its values times inertia / mass.
AxisHand light_hand(const Kind& kind, double mass) {
  const double per = kind.axis.inertia / mass;
  return {hand_grips[0].stiffness * per, hand_grips[0].damping * per};
}

/// Rate-hardness and rise time, up to twice the recommended stiffness, at the recommended damping.
void add_hardness(const Kind& kind, const AxisHand& hand, double stiffness, double damping,
                  DeviceCurves& out) {
  SampledAxis axis = kind.axis;
  axis.virtual_damping = damping;
  const std::string at =
      std::string(kind.name) + ", damping " + number_text(damping, 3) + ' ' + kind.damping;
  const auto panel = [&](const char* what, const ChartAxis& y) {
    return ChartPanel{at + ": " + what,
                      log_axis(std::string("stiffness, ") + kind.stiffness),
                      y,
                      {{"at this damping"}, {"recommended"}},
                      {},
                      {}};
  };
  ChartPanel hardness =
      panel("rate-hardness", log_axis(std::string("over 10 ms, ") + kind.stiffness));
  ChartPanel rise = panel("rise of the force", {"10 to 90 %, s"});
  const auto add = [](ChartSeries& series, double x, double y) {
    series.x.push_back(x);
    series.y.push_back(y);
  };
  // The chart's axis is logarithmic; the hardness is 0 if nothing is rendered within 10 ms.
  const auto add_rise = [&](ChartSeries& series, double k, double time) {
    if (std::isfinite(time)) add(series, k, time);
  };
  const auto add_hard = [&](ChartSeries& series, double k, double hard) {
    if (hard > 0) add(series, k, hard);
  };
  for (const double k : evenly_by_ratio(stiffness / 16, 2 * stiffness)) {
    const double hard = rate_hardness(axis, k), time = rise_time(axis, k, hand);
    out.csv.append(kind.name).append(row({k, damping, hard, time}));
    add_hard(hardness.series[0], k, hard);
    add_rise(rise.series[0], k, time);
  }
  hardness.series[1].form = rise.series[1].form = ChartSeries::Form::points;
  add_hard(hardness.series[1], stiffness, rate_hardness(axis, stiffness));
  add_rise(rise.series[1], stiffness, rise_time(axis, stiffness, hand));
  out.chart.panels.push_back(hardness);
  out.chart.panels.push_back(rise);
}

}  // namespace

Complex rendered_impedance(const SampledAxis& axis, double stiffness, double omega) {
  const double T = axis.sample_time;
  const Complex before = elementary::polar(1, -omega * T);
  const Complex computed = stiffness + axis.virtual_damping * (1.0 - before) / T;
  return computed * elementary::polar(1, -omega * axis.delay) * (1.0 - before) /
         -(omega * T * omega);
}

Complex wanted_impedance(double stiffness, double damping, double omega) {
  return {damping, -stiffness / omega};
}

std::vector<ZWidthPoint> z_width(const SampledAxis& axis, double most_damping) {
  std::vector<double> dampings{0};
  if (most_damping > 0)
    for (const double b : evenly_by_ratio(most_damping / 100, most_damping)) dampings.push_back(b);
  std::vector<ZWidthPoint> out;
  for (const double damping : dampings) {
    SampledAxis at = axis;
    at.virtual_damping = damping;
    out.push_back({damping, largest_stable_stiffness(at), largest_passive_stiffness(at)});
  }
  return out;
}

std::vector<LimitAt> limits_by_delay(const SampledAxis& axis) {
  const double usual = axis.delay > 0 ? axis.delay : axis.sample_time;
  return limits_over(evenly_by_ratio(usual / 20, 4 * usual), [&](double delay) {
    SampledAxis at = axis;
    at.delay = delay;
    return at;
  });
}

std::vector<LimitAt> limits_by_rate(const SampledAxis& axis) {
  return limits_over(evenly_by_ratio(500, 1e4), [&](double rate) {
    SampledAxis at = axis;
    at.sample_time = 1 / rate;
    return at;
  });
}

std::vector<LimitAt> limits_by_hand_damping(const SampledAxis& axis) {
  // Scaled for rotations, with a mass of 0.3 kg, the same for hands as for handles.
  const double per = axis.inertia / 0.3;
  return limits_over(evenly_by_ratio(0.1 * std::min(1.0, per), 20 * std::min(1.0, per)),
                     [&](double damping) {
                       SampledAxis at = axis;
                       at.damping += damping;
                       return at;
                     });
}

std::vector<LimitAt> limits_by_step(const SampledAxis& axis, double step, double friction) {
  const double stable = largest_stable_stiffness(axis), passive = largest_passive_stiffness(axis);
  std::vector<LimitAt> out;
  for (const double value : evenly_by_ratio(step / 20, 100 * step)) {
    const double quiet = 2 * friction / value;
    out.push_back(
        {value, std::min(stable, quiet), std::min(passive, quiet), quiet < passive ? -1.0 : 0.0});
  }
  return out;
}

std::vector<DeviceCurves> device_curves(const TuningResults& results) {
  DeviceCurves width{
      "z_width", "axis,damping,stable,passive\n", {"Z-width of the device alone", {}}};
  DeviceCurves limits{"limits",
                      "axis,property,value,stable,passive,slope\n",
                      {"What limits a wall on the device alone", {}}};
  DeviceCurves impedance{
      "impedance",
      "axis,frequency,wanted_re,wanted_im,rendered_re,rendered_im,handle_re,handle_im\n",
      {"Impedance of a wall, wanted and rendered", {}}};
  DeviceCurves hardness{"hardness",
                        "axis,stiffness,damping,rate_hardness,rise_time\n",
                        {"How hard a wall on the device feels", {}}};
  const Coupling gains = recommended_coupling(results);
  const bool object = in_object_norm(gains.mode);
  for (const Kind& kind : kinds_of(results)) {
    const bool turns = kind.step == std::string("rad");
    add_z_width(kind, width);
    add_limits(kind, limits);
    // The felt rotational stiffness depends on the probe, not only on k.
    if (turns && object) continue;
    const double stiffness = turns ? gains.k_r : object ? gains.k : gains.k_t;
    const double damping = turns ? gains.b_r : gains.b_t;
    if (!has_recommendation(results) || !(stiffness > 0)) continue;
    add_impedance(kind, stiffness, damping, impedance);
    add_hardness(kind, light_hand(kind, results.device.at("mass")), stiffness, damping, hardness);
  }
  std::vector<DeviceCurves> out{width, limits, impedance, hardness};
  std::erase_if(out, [](const DeviceCurves& curves) { return curves.chart.panels.empty(); });
  return out;
}

std::vector<StudyFile> device_curve_files(const TuningResults& results) {
  std::vector<StudyFile> out;
  for (const DeviceCurves& curves : device_curves(results)) {
    out.push_back({curves.name + ".csv", curves.csv});
    out.push_back({curves.name + ".svg", to_svg(curves.chart)});
  }
  return out;
}

}  // namespace sonde
