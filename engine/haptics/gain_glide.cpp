// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/gain_glide.hpp"

namespace sonde {

void GainGlide::restart(const Coupling& coupling) noexcept {
  from_ = to_ = now_ = coupling;
  there_ = true;
}

void GainGlide::set(const Coupling& wanted) noexcept {
  if (wanted.mode != now_.mode) return restart(wanted);
  from_ = now_;
  to_ = wanted;
  since_ = 0;
  there_ = false;
}

const Coupling& GainGlide::next(double dt) noexcept {
  if (there_) return now_;
  since_ += dt > 0 ? dt : 0;
  there_ = since_ >= time_;
  now_ = to_;
  if (there_) return now_;
  const double share = since_ / time_;
  for (double Coupling::*gain :
       {&Coupling::k, &Coupling::k_t, &Coupling::k_r, &Coupling::b_t, &Coupling::b_r})
    now_.*gain = from_.*gain + share * (to_.*gain - from_.*gain);
  return now_;
}

}  // namespace sonde
