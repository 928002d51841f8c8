// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/coupling/gain_glide.hpp"

#include <algorithm>
#include <utility>

namespace sonde {
namespace {

constexpr double Coupling::*gains[] = {&Coupling::k, &Coupling::k_t, &Coupling::k_r, &Coupling::b_t,
                                       &Coupling::b_r};
constexpr double Coupling::*limits[] = {&Coupling::max_force, &Coupling::max_torque};

bool same_gains(const Coupling& a, const Coupling& b) {
  return a.mode == b.mode &&
         std::ranges::all_of(gains, [&](double Coupling::*gain) { return a.*gain == b.*gain; });
}

}  // namespace

void GainGlide::restart(const Coupling& coupling) noexcept {
  from_ = to_ = coupling;
  blend_ = {.now = coupling, .before = coupling};
  next_.reset();
  arrived_ = true;
  turned_back_ = false;
}

void GainGlide::set(const Coupling& wanted) noexcept {
  if (blend_.share < 1) {
    next_ = wanted;
    if (!same_gains(wanted, to_)) return;
    for (double Coupling::*limit : limits) to_.*limit = wanted.*limit;
    next_.reset();
    return;
  }
  turned_back_ = false;
  from_ = blend_.now;
  to_ = wanted;
  share_ = 0;
  arrived_ = false;
}

const GainGlide::Blend& GainGlide::next(double dt, double most) noexcept {
  if (arrived_) return blend_;
  const double step = dt > 0 ? dt : 0;
  const bool held = step > 0 && !(most > 0);
  if (held && next_ && !turned_back_) turn_back();
  share_ += std::min(time_ > 0 ? step / time_ : 1, most);
  arrived_ = share_ >= 1 - 1e-12;  // within rounding of the last step
  blend_ = {.now = to_, .before = to_};
  if (!arrived_) blend(share_);
  if (!next_) return blend_;
  for (double Coupling::*limit : limits)
    blend_.now.*limit = std::min(blend_.now.*limit, (*next_).*limit);
  if (arrived_) set(*std::exchange(next_, std::nullopt));
  return blend_;
}

void GainGlide::turn_back() noexcept {
  std::swap(from_, to_);
  share_ = 1 - share_;
  turned_back_ = true;
}

void GainGlide::blend(double share) noexcept {
  const auto on_the_way = [&](double Coupling::*value) {
    return from_.*value + share * (to_.*value - from_.*value);
  };
  for (double Coupling::*limit : limits)
    blend_.now.*limit = std::min(to_.*limit, on_the_way(limit));
  if (from_.mode == to_.mode) {
    for (double Coupling::*gain : gains) blend_.now.*gain = on_the_way(gain);
  } else if (in_object_norm(from_.mode) && in_object_norm(to_.mode)) {
    for (double Coupling::*gain : gains) blend_.now.*gain = on_the_way(gain);
    blend_.now.mode = Coupling::Mode::damped;
    blend_.now.b_t = to_.mode == Coupling::Mode::damped ? share * to_.b_t : (1 - share) * from_.b_t;
  } else {
    blend_.before = from_;
    blend_.share = share;
  }
}

}  // namespace sonde
