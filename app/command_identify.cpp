// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "app/connected_response.hpp"
#include "app/interrupt.hpp"
#include "app/profiles.hpp"
#include "app/progress_line.hpp"
#include "engine/base/error.hpp"
#include "engine/study/identification/identification_report.hpp"
#include "engine/study/identification/identified_profile.hpp"
#include "engine/study/identification/pulse_plan.hpp"
#include "engine/study/identification/simulated_response.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::app {
namespace {

constexpr double sample_time = 1e-3;  // s, of the simulated pulses: what drivers run at

struct IdentifyOptions {
  std::string recording, simulated, connected, device;
  bool hands_off = false;
  bool all_rows = false;
  std::string profile;  ///< to write; empty: none
  std::string record;   ///< to write; empty: none
  PulseLimits limits;
  bool has_limits = false;  ///< they were asked for
  bool json = false;
};

void check(const IdentifyOptions& options) {
  if (!options.recording.empty() + !options.simulated.empty() + !options.connected.empty() != 1)
    throw UsageError("it takes either a RECORDING, --simulated or --connected");
  if (options.device.empty() && options.simulated.empty())
    throw UsageError("--device is missing: the profile whose other values are kept");
  if (!options.record.empty() && !options.recording.empty())
    throw UsageError("--record needs --simulated or --connected");
  if (!options.recording.empty() && options.has_limits)
    throw UsageError("--force and --torque: a recording has its own pulses");
  if (!options.connected.empty() && !options.hands_off)
    throw UsageError("--connected pushes the handle with up to " +
                     number_text(options.limits.force, 3) + " N and " +
                     number_text(options.limits.torque, 3) +
                     " N·m: let go of it, clear 5 cm around it, and give --hands-off");
  if (options.connected.empty() && options.hands_off)
    throw UsageError("--hands-off needs --connected");
  if (options.all_rows && options.recording.empty())
    throw UsageError("--all-rows is of a RECORDING");
  if (same_file(options.record, options.profile))
    throw UsageError("--record and --out name the same file");
  std::vector<std::filesystem::path> inputs;
  for (const std::string& file : {options.recording, options.device, options.simulated})
    if (!file.empty()) inputs.emplace_back(file);
  if (!options.profile.empty()) check_output("--out", options.profile, inputs);
  if (!options.record.empty()) check_output("--record", options.record, inputs);
}

/// The answer to the pulses, and the profile whose other values are kept.
ConnectedResponse response_of(const IdentifyOptions& options) {
  const DeviceProfile device =
      device_named(options.device.empty() ? options.simulated : options.device);
  if (!options.recording.empty()) return {read_response(options.recording), device};
  if (!options.connected.empty()) {
    ProgressLine line(false);
    return connected_response(options.connected, device, options.limits, line.percent("measuring"));
  }
  const DeviceProfile simulates = device_named(options.simulated);
  return {
      simulated_response(simulated(simulates), plan_pulses(simulates, options.limits, sample_time)),
      device};
}

/// A file, or a device.
std::string subject_of(const IdentifyOptions& options) {
  if (!options.recording.empty()) return options.recording;
  return options.connected.empty() ? options.simulated : options.connected;
}

/// What cannot be told from a recording is an error of that file.
Identification identified(const IdentifyOptions& options, const Response& response) {
  try {
    const bool all = !options.connected.empty() || options.all_rows;
    ProgressLine line(false);
    const Progress percent = line.percent("computing");
    return identify(response, all ? Rows::all_logged : Rows::maybe_missing,
                    [&](double fraction) { return percent(fraction) && !interrupt_noted(); });
  } catch (const InputError& error) {
    throw InputError::in(subject_of(options), error.what());
  }
}

std::string source_of(const IdentifyOptions& options, const Identification& found) {
  std::size_t pulses = 0;
  for (const IdentifiedAxis& axis : found.axes) pulses += axis.pulses;
  const std::string from = !options.simulated.empty() ? "the simulated device " + options.simulated
                           : !options.connected.empty()
                               ? "the connected device " + options.connected
                               : std::filesystem::path(options.recording).filename().string();
  return "sonde identify, " + std::to_string(pulses) + " pulses of " + from +
         "; low and high: 99 %";
}

void run(const IdentifyOptions& options) {
  check(options);
  const auto [response, device] = response_of(options);
  const Identification found = identified(options, response);
  const std::string profile =
      device_profile_text(identified_profile(device, found, source_of(options, found)));
  if (interrupt_noted()) throw Cancelled();
  // Both or none.
  std::vector<std::unique_ptr<PendingFile>> files;
  if (!options.record.empty())
    files.push_back(std::make_unique<PendingFile>(options.record, response_text(response)));
  if (!options.profile.empty())
    files.push_back(std::make_unique<PendingFile>(options.profile, profile));
  for (const auto& file : files) file->commit();
  write_result(
      {}, options.json ? identification_json(found, device) : identification_text(found, device));
}

}  // namespace

Command add_identify_command(CLI::App& program) {
  const auto options = std::make_shared<IdentifyOptions>();
  CLI::App* parser = program.add_subcommand(
      "identify",
      "Measures a device's mass, damping, friction, delay and encoder step; writes a "
      "profile");
  parser->add_option("RECORDING", options->recording,
                     "CSV of a device's answer to pulses: t, the commanded wrench, the pose");
  parser->add_option("--simulated", options->simulated,
                     "instead of a recording: give the pulses to the simulated device of this "
                     "profile, an id or a file");
  parser->add_option("--device", options->device,
                     "profile whose other values are kept, an id or a file; without it the "
                     "simulated one");
  parser->add_option("--connected", options->connected,
                     "instead of a recording: give the pulses to this connected force device, as "
                     "sonde devices lists it");
  parser->add_flag("--hands-off", options->hands_off,
                   "consent to that: nobody holds the handle, and nothing is within 5 cm of it");
  parser->add_flag("--all-rows", options->all_rows,
                   "no row is missing in the recording, as --record writes it of a connected "
                   "device: a row that comes late is a late tick, and the command before it held");
  parser->add_option("--out", options->profile,
                     "profile to write, NAME.json, whole or not at all; without it none");
  parser->add_option("--record", options->record,
                     "CSV to write: the device's answer, whose commands are the pulses");
  const CLI::Option* const force =
      parser->add_option("--force", options->limits.force, "largest force of the pulses, N")
          ->check(check_positive)
          ->capture_default_str();
  const CLI::Option* const torque =
      parser->add_option("--torque", options->limits.torque, "largest torque of the pulses, N·m")
          ->check(check_positive)
          ->capture_default_str();
  parser->add_flag("--json", options->json, "write JSON instead of text");
  return {parser, [options, force, torque] {
            options->has_limits = force->count() + torque->count() > 0;
            run(*options);
          }};
}

}  // namespace sonde::app
