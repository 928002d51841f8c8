// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/stage.hpp"

#include <vtkPolyData.h>

#include <utility>

#include "ui/views/surface.hpp"

namespace sonde::ui {

Stage make_stage(Opened opened) {
  Stage stage;
  stage.probe_surface = make_surface(opened.pair.probe().soup);
  stage.fixed_surface = make_surface(opened.pair.fixed().soup);
  stage.session = std::make_unique<Session>(std::move(opened));
  return stage;
}

}  // namespace sonde::ui
