// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "ui/document/session.hpp"
#include "ui/views/drawn_bodies.hpp"

namespace sonde::ui {

/// A session with its bodies as they are drawn. A worker makes it, because that takes long.
struct DrawnSession {
  std::unique_ptr<Session> session;
  DrawnBodies bodies;
};
DrawnSession draw_session(const LoadedScene& loaded);

}  // namespace sonde::ui
