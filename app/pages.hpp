// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sonde::app {

/// The manual page (section 1, in the language of man(7)) of a program, from its parser's commands,
/// options, defaults and words. `see_also`: other pages, "sonde-view(1)".
std::string manual_page(const CLI::App& program, const std::string& version,
                        const std::string& see_also);

/// A completion script for bash: commands, options, and the words of an option; files everywhere
/// else.
std::string bash_completion(const CLI::App& program);

}  // namespace sonde::app
