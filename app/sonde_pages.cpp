// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-pages FOLDER: writes the manual pages and bash completions of both programs, from the
// tables that they parse their command lines with. Run by the build.

#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/command_line.hpp"
#include "app/pages.hpp"
#include "ui/shell/arguments.hpp"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  if (!(out << text << std::flush)) throw std::runtime_error(file.string() + ": cannot be written");
}

void write_pages(const fs::path& folder, const CLI::App& program, const std::string& see_also) {
  const std::string& name = program.get_name();
  write(folder / (name + ".1"), sonde::app::manual_page(program, SONDE_VERSION, see_also));
  write(folder / "completions" / name, sonde::app::bash_completion(program));
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2 || argv[1][0] == '-') throw std::invalid_argument("usage: sonde-pages FOLDER");
  CLI::App headless(sonde::app::program_summary, sonde::app::program_name);
  const auto commands = sonde::app::declare_command_line(headless);
  write_pages(argv[1], headless, "sonde\\-view (1)");
  CLI::App desktop;
  sonde::ui::Arguments arguments;
  sonde::ui::declare_command_line(desktop, arguments);
  write_pages(argv[1], desktop, "sonde (1)");
} catch (const std::exception& error) {
  std::cerr << "sonde-pages: " << error.what() << '\n';
  return 1;
}
