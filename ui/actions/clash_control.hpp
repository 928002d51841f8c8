// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "engine/study/assembly/clash.hpp"
#include "ui/actions/flight.hpp"
#include "ui/base/job.hpp"

class QDockWidget;
class QMainWindow;

namespace sonde::ui {

class ClashPanel;
class Session;
class Viewport;

/// The clashes of the open scene: found in a thread of their own, listed in a dock, and flown to.
class ClashControl : public QObject {
 public:
  /// Its dock is added to the window, in the place of that one.
  ClashControl(Viewport& viewport, QMainWindow& window, QDockWidget& beside);

  ClashPanel& panel() { return *panel_; }
  /// Null: nothing is open. What is being found is given up.
  void attach(Session* session, bool same_document = false);
  void find();
  const std::vector<Clash>& found() const { return found_; }

 private:
  void show(std::size_t clash);

  Viewport& viewport_;
  ClashPanel* panel_;
  Session* session_ = nullptr;
  Job job_;
  Flight flight_;
  std::vector<AssemblyPart> parts_;
  std::vector<Clash> found_;
};

/// What is clashing in a scene: the probe at that pose, and each part of the fixed body, felt or
/// not, in the fixed body's mesh frame. Names are unique.
std::vector<AssemblyPart> assembly_of(const Session& session, const Pose& X_FM);

}  // namespace sonde::ui
