// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sonde::ui {

/// The command line of sonde-view, checked.
struct Arguments {
  std::vector<std::string> files;  ///< none: the start page; one: a scene; two: probe and fixed
  std::optional<double> unit;      ///< metres
  std::string device;              ///< what holds the probe; empty: the scene's device or the mouse
  std::string screenshot;          ///< a picture to write, then end; empty for none
  std::string demo;                ///< a picture to write after playing the scene's trajectory
};

/// Declares the whole command line of sonde-view, to be parsed into `arguments`.
void declare_command_line(CLI::App& app, Arguments& arguments);

/// Either arguments, or an exit code where nothing remains to do (help, version: 0; wrong usage:
/// 2), after printing it.
struct Parsed {
  Arguments arguments;
  std::optional<int> exit_code;
};
Parsed parse_arguments(int argc, char** argv);

}  // namespace sonde::ui
