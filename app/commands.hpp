// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/options.hpp"

namespace sonde::app {

/// Each adds its subcommand to the program's parser.
Command add_calibrate_command(CLI::App& program);
Command add_clash_command(CLI::App& program);
Command add_compare_command(CLI::App& program);
Command add_devices_command(CLI::App& program);
Command add_identify_command(CLI::App& program);
Command add_info_command(CLI::App& program);
Command add_insert_command(CLI::App& program);
Command add_merge_command(CLI::App& program);
Command add_points_command(CLI::App& program);
Command add_query_command(CLI::App& program);
Command add_replay_command(CLI::App& program);
Command add_trade_command(CLI::App& program);
Command add_traces_command(CLI::App& program);
Command add_tune_command(CLI::App& program);

}  // namespace sonde::app
