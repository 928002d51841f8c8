// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/drawn_session.hpp"

#include <vtkPolyData.h>

#include "engine/base/threads.hpp"

namespace sonde::ui {

/// The session may search where it begins: the bodies are drawn meanwhile.
DrawnSession draw_session(const LoadedScene& loaded) {
  DrawnSession drawn;
  run_both(
      loaded.pair.probe().soup.triangles.size() >= worth_a_thread, {},
      [&](const Progress&) { drawn.session = std::make_unique<Session>(loaded); },
      [&](const Progress&) { drawn.bodies = draw_bodies(loaded); });
  return drawn;
}

}  // namespace sonde::ui
