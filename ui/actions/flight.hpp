// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <QVariantAnimation>

#include "ui/document/loaded_scene.hpp"
#include "ui/views/seeing.hpp"

namespace sonde::ui {

class Viewport;

/// Takes the camera to a place in half a second, and puts a ring round what is there.
class Flight : public QObject {
 public:
  Flight(Viewport& viewport, QObject* parent);

  /// The ring goes after some seconds.
  void show(const PointedPlace& place);
  /// Nothing is pointed out any more, and the camera stays.
  void stop();
  bool flying() const { return flight_.state() == QAbstractAnimation::Running; }

 private:
  void fly(double part);

  Viewport& viewport_;
  QVariantAnimation flight_;
  CameraPlace from_{}, to_{};
  QTimer pointing_;  ///< until the ring goes
};

}  // namespace sonde::ui
