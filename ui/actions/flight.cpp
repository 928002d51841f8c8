// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/flight.hpp"

#include <cmath>

#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr int flight_ms = 450;
constexpr int pointing_ms = 8000;

}  // namespace

Flight::Flight(Viewport& viewport, QObject* parent) : QObject(parent), viewport_(viewport) {
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  flight_.setDuration(flight_ms);
  flight_.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&flight_, &QVariantAnimation::valueChanged, this,
          [this](const QVariant& part) { fly(part.toDouble()); });
  pointing_.setSingleShot(true);
  connect(&pointing_, &QTimer::timeout, this, [this] { viewport_.point_out({}); });
}

void Flight::show(const PointedPlace& place) {
  viewport_.point_out(place);
  pointing_.start(pointing_ms);
  flight_.stop();
  from_ = viewport_.place();
  to_ = viewport_.before(place);
  flight_.start();
}

void Flight::stop() {
  flight_.stop();
  pointing_.stop();
}

/// Round the target, which moves in a line, at a distance that changes in proportion.
void Flight::fly(double part) {
  const Vec3 from = from_.position - from_.target, to = to_.position - to_.target;
  const Quat turn = Quat::FromTwoVectors(from, to);
  const Vec3 direction = Quat::Identity().slerp(part, turn) * from.normalized();
  const double distance = std::pow(from.norm(), 1 - part) * std::pow(to.norm(), part);
  const Vec3 target = (1 - part) * from_.target + part * to_.target;
  const Vec3 up = (1 - part) * from_.up + part * to_.up;
  const bool along = direction.cross(up).norm() < 1e-3;
  viewport_.look({target + direction * distance, target, along ? to_.up : up});
}

}  // namespace sonde::ui
