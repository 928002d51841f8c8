// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/platform/wakeful_processors.hpp"

namespace sonde {

WakefulProcessors::WakefulProcessors(bool wanted, const char*) noexcept
    : words_(wanted ? "processors may sleep deeply: this system is not asked" : "") {}

WakefulProcessors::~WakefulProcessors() = default;

}  // namespace sonde
