// SPDX-License-Identifier: GPL-3.0-or-later
// sonde: the program without a window.

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/command_line.hpp"
#include "app/interrupt.hpp"
#include "engine/base/error.hpp"
#include "engine/platform/program.hpp"
#include "engine/simd/instruction_set.hpp"
#include "engine/text/printable.hpp"

namespace {

enum ExitCode { done = 0, wrong_usage = 2, bad_input = 3, our_fault = 4, interrupted = 130 };

int fail(ExitCode code, const std::string& reason) {
  std::cerr << "sonde: " << reason << '\n';
  return code;
}

/// What is wrong, where no known command was named.
std::string about_commands(const CLI::App& program) {
  const std::vector<std::string> extra = program.remaining();
  std::string text = extra.empty() ? "no command" : "unknown command " + extra.front();
  const char* separator = ": the commands are ";
  for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    text.append(separator).append(command->get_name());
    separator = ", ";
  }
  return text;
}

int wrong_usage_of(const CLI::App& program, const std::string& reason) {
  std::string command = "sonde";
  for (const CLI::App* parsed : program.get_subcommands()) command += " " + parsed->get_name();
  return fail(wrong_usage, sonde::printable(reason) + "\nTry '" + command + " --help'.");
}

/// Help and version are no errors; the rest of what the parser throws is wrong usage.
int after_parse_error(const CLI::App& program, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return program.exit(error);
  const bool no_command = program.get_subcommands().empty();
  return wrong_usage_of(program, no_command ? about_commands(program) : error.what());
}

int run(int argc, char** argv) {
  std::vector<std::string> arguments = sonde::begin_program(argc, argv);
  sonde::check_instruction_set();
  CLI::App program(sonde::app::program_summary, sonde::app::program_name);
  program.allow_windows_style_options(false);  // "/a/b" is a file, there too
  const auto commands = sonde::app::declare_command_line(program);
  try {
    std::ranges::reverse(arguments);  // as the parser takes them
    program.parse(std::move(arguments));
    for (const auto& command : commands)
      if (command.parser->parsed()) command.run();
  } catch (const CLI::ParseError& error) {
    return after_parse_error(program, error);
  } catch (const sonde::app::UsageError& error) {
    return wrong_usage_of(program, error.what());
  }
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  sonde::app::catch_interrupts();
  try {
    return run(argc, argv);
  } catch (const sonde::InputError& error) {
    return fail(bad_input, sonde::printable(error.what()));
  } catch (const sonde::Cancelled&) {
    return interrupted;
  } catch (const std::bad_alloc&) {
    return fail(our_fault, "out of memory");
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again)
      return fail(our_fault, "internal fault: " + sonde::printable(error.what()));
    return fail(our_fault, "out of memory or of threads: no thread can be started");
  } catch (const std::exception& error) {
    return fail(our_fault, "internal fault: " + sonde::printable(error.what()));
  }
}
