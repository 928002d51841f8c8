// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/document/instant.hpp"

namespace sonde::ui {

/// What both bodies are taken for, and why.
QString natures(const Body& probe, const Body& fixed);

/// What the probe does now, and what keeps the force away, if anything.
QString happening(const Instant& now);

}  // namespace sonde::ui
