// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.hpp"

#include "app/commands.hpp"
#include "engine/simd/instruction_set.hpp"

namespace sonde::app {

std::vector<Command> declare_command_line(CLI::App& program) {
  program.set_version_flag("--version", "sonde " SONDE_VERSION);
  program.add_flag_callback(
      "--instruction-set",
      [] { throw CLI::CallForVersion(std::string(name_of(instruction_set())), 0); },
      "Print which vector instructions are used, baseline, avx2 or avx512, and exit; the "
      "environment variable SONDE_INSTRUCTION_SET chooses others, for reports of faults");
  program.require_subcommand(1);
  program.footer(
      "Exit codes: 0 done, 2 wrong usage, 3 bad input, 4 a fault of ours, 130 interrupted.");
  return {
      add_info_command(program),     add_query_command(program),   add_replay_command(program),
      add_trade_command(program),    add_traces_command(program),  add_tune_command(program),
      add_compare_command(program),  add_merge_command(program),   add_calibrate_command(program),
      add_identify_command(program), add_devices_command(program), add_clash_command(program),
      add_insert_command(program),   add_points_command(program)};
}

}  // namespace sonde::app
