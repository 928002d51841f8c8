// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "engine/haptics/loop/background_search.hpp"
#include "engine/haptics/loop/servo.hpp"

namespace sonde::ui {

/// What both bodies are taken for, and why.
QString natures(const Body& probe, const Body& fixed);

/// What the probe does now, and what keeps the force away, if anything.
QString happening(const Snapshot& snapshot, const std::optional<BackgroundResult>& searched);

}  // namespace sonde::ui
