// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>

#include "ui/base/job.hpp"

namespace sonde::ui {

class Session;
class Viewport;

/// Looks for the triangles of each body that go through others of it, once for a pair of bodies, in
/// a worker with progress that can be cancelled; and shows them.
class CrossingFinder : public QObject {
  Q_OBJECT
 public:
  CrossingFinder(Viewport& viewport, QWidget& window);

  void set_on(bool on);
  /// Other bodies from now on; null: none.
  void attach(const Session* session);

 signals:
  /// What was found, or that it was given up.
  void say(const QString& what);
  /// It was given up, or has failed: nothing is shown.
  void given_up();

 private:
  void begin();

  Viewport& viewport_;
  Job job_;
  const Session* session_ = nullptr;
  bool on_ = false;
  bool known_ = false;
};

}  // namespace sonde::ui
