// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session.hpp"

#include <utility>

namespace sonde::ui {

Session::Session(Opened opened)
    : opened_(std::move(opened)),
      device_(opened_.start),
      coupling_(opened_.coupling),
      companion_(opened_.probe, opened_.fixed),
      servo_(opened_.probe, opened_.fixed, Method::pdg, coupling_, opened_.servo) {
  servo_.start(device_);
}

void Session::set_device_pose(const Pose& X_FM) {
  device_ = X_FM;
  servo_.set_device_pose(X_FM);
}

void Session::set_coupling(const Coupling& coupling) {
  coupling_ = coupling;
  servo_.set_coupling(coupling);
}

void Session::set_paused(bool paused) {
  paused_ = paused;
  servo_.set_paused(paused);
}

void Session::reset() {
  servo_.stop();
  device_ = opened_.start;
  servo_.start(device_);
  servo_.set_coupling(coupling_);
  set_paused(false);
}

}  // namespace sonde::ui
