// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QStringList>

namespace sonde::ui {

struct LoadedScene;
class PosePanel;
class Viewport;

/// What the arrow keys go along besides the bodies' axes: the face that was clicked last in the
/// view, and the scene's axes.
class NudgeControl : public QObject {
 public:
  NudgeControl(Viewport& viewport, PosePanel& panel, QObject* parent);

  /// Of other bodies no face was clicked yet.
  void attach(const LoadedScene& loaded);
  /// A click in the view, whatever else it is for. Beside the bodies it changes nothing.
  void click(QPointF at);

 private:
  Viewport& viewport_;
  PosePanel& panel_;
  QStringList parts_;  ///< of the fixed body, where that is of several
};

}  // namespace sonde::ui
