// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/haptics/loop/lessened.hpp"

namespace sonde {
namespace {

constexpr double nearly = 1e-6;      // share of a limit, for rounding: a recording has 32 bits
constexpr double noticeably = 1e-2;  // share of the wanted change
// Share of the ramp: shown as "100 %", it would explain nothing.
constexpr double nearly_whole = 0.995;

Lessened lessened(const Vec3& given, const Vec3& asked, double most, const HandState& hand) {
  if (given.isZero(0)) return Lessened::nothing;
  if (hand.withheld == Withheld::unsettled) return Lessened::fading;
  if (hand.share < nearly_whole) return Lessened::coming_in;
  const Vec3 wanted = hand.share * asked;
  if (hand.slewed && (wanted - given).norm() > noticeably * wanted.norm()) return Lessened::slewed;
  return given.norm() >= most * (1 - nearly) ? Lessened::limited : Lessened::nothing;
}

}  // namespace

Lessened force_lessened(const Wrench& given, const HandState& hand, const Coupling& coupling) {
  return lessened(given.force, hand.asked.force, coupling.max_force, hand);
}

Lessened torque_lessened(const Wrench& given, const HandState& hand, const Coupling& coupling) {
  return lessened(given.torque, hand.asked.torque, coupling.max_torque, hand);
}

const char* words(Lessened by) {
  switch (by) {
    case Lessened::nothing:
      return "";
    case Lessened::coming_in:
      return "coming in";
    case Lessened::fading:
      return "fading: not settled";
    case Lessened::slewed:
      return "changes no faster";
    case Lessened::limited:
      return "limit";
  }
  return "";
}

}  // namespace sonde
