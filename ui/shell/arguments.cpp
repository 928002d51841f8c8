// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/arguments.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "engine/text/file_unit.hpp"
#include "engine/text/printable.hpp"

namespace sonde::ui {

void declare_command_line(CLI::App& app, Arguments& arguments) {
  app.name("sonde-view");
  app.description("Feel how two polygon soups touch: the desktop program.");
  app.set_version_flag("--version", "sonde-view " SONDE_VERSION);
  app.add_option("files", arguments.files,
                 "A scene (NAME.sonde.json), or two meshes: the probe and the fixed body")
      ->type_name("SCENE | PROBE FIXED");
  app.add_option_function<std::string>(
         "--unit", [&](const std::string& unit) { arguments.unit = unit_in_metres(unit); },
         "Unit of two meshes")
      ->check(CLI::IsMember(file_unit_names()));
  app.add_option(
         "--device", arguments.device,
         "What holds the probe: a device profile's id (simulated), a connected device's "
         "name or ids, a path (a profile.json, a recorded path.csv, /dev/hidrawN), auto (the "
         "first that opens, else the mouse), mouse, or path (the scene's recorded one)")
      ->type_name("NAME | PATH | auto");
  auto* picture =
      app.add_option("--screenshot", arguments.screenshot,
                     "Write a picture of the window as it opens (PNG), then end; asks nothing")
          ->type_name("FILE");
  app.add_option("--demo", arguments.demo,
                 "Play the scene's path, write a picture (PNG) of its deepest tick at the path's "
                 "time, print its figures, then end; asks nothing")
      ->type_name("PICTURE")
      ->excludes(picture);
  app.footer("Without files: the start page; for a picture, the scene spoon-in-cup.");
}

namespace {

Parsed refused(const std::string& reason) {
  std::cerr << "sonde-view: " << printable(reason) << "\nTry 'sonde-view --help'.\n";
  Parsed parsed;
  parsed.exit_code = 2;
  return parsed;
}

}  // namespace

Parsed parse_arguments(int argc, char** argv) {
  Parsed parsed;
  Arguments& arguments = parsed.arguments;
  CLI::App app;
  declare_command_line(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      parsed.exit_code = app.exit(error);  // help and version are no errors
      return parsed;
    }
    return refused(error.what());
  }
  if (arguments.files.size() > 2)
    return refused("one scene or two meshes are opened, not " +
                   std::to_string(arguments.files.size()) + " files");
  if (app.count("--device") > 0 && arguments.device.empty())
    return refused("--device wants a name, a path or auto");
  if (arguments.files.size() == 1 && arguments.unit)
    return refused("--unit is for two meshes; a scene says its own");
  return parsed;
}

}  // namespace sonde::ui
