// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/options.hpp"

namespace sonde::app {

inline constexpr const char* program_name = "sonde";
inline constexpr const char* program_summary =
    "Penetration depth of two polygon soups, and the force that follows from it.";

/// Declares the whole command line of `sonde`, and the function of each of its commands.
std::vector<Command> declare_command_line(CLI::App& program);

}  // namespace sonde::app
