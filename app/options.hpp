// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/penetration/search/static_search.hpp"
#include "engine/settings/settings.hpp"

namespace sonde::app {

/// Flags that contradict each other, found after parsing. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A command of the program: its parser, and its function after parsing.
struct Command {
  CLI::App* parser;
  std::function<void()> run;
};

/// The options of the search: the flags of every computing command.
struct SolverOptions {
  std::string method = "pdg";
  std::string mode;  ///< "static" or "coherent"
  Budget budget;
  std::uint64_t seed = 1;
  /// Wanted whole, or not at all. By default about as much work goes into it as into the search, in
  /// what that leaves of a limited time.
  std::optional<bool> bound;
  double sure = 0.9;         ///< the share of answers that should keep to what they claim
  bool time_phases = false;  ///< say where the time of an answer went
  unsigned threads = 0;      ///< 0: as many as the machine runs at once

  bool coherent() const { return mode == "coherent"; }
  Method chosen_method() const { return method_named(method).value(); }
  StaticOptions static_options() const {
    return {.method = chosen_method(),
            .budget = budget,
            .seed = seed,
            .sure = sure,
            .want_lower_bound = bound.value_or(true),
            .whole_bound = bound.value_or(false),
            .share_for_bound = bound.value_or(false) ? 0.3 : 0,
            .time_phases = time_phases};
  }
};
void add_flags(CLI::App& parser, SolverOptions& options, const std::string& default_mode);

/// The format and the target of results.
struct OutputOptions {
  std::string out = "-";  ///< "-": standard output
  bool json = false;
  bool quiet = false;

  bool to_file() const { return out != "-"; }
};
void add_flags(CLI::App& parser, OutputOptions& options);

/// Values given on the command line for settings of a table, by key. One flag for each setting.
using SettingValues = std::map<std::string, double>;
void add_setting_flags(CLI::App& parser, std::span<const Setting> settings, SettingValues& values);

/// Refuses, before any work, an output that cannot be written or is one of the inputs.
void check_output(const OutputOptions& options, const std::vector<std::filesystem::path>& inputs);
/// The same for a file that another flag names.
void check_output(const std::string& flag, const std::string& file,
                  const std::vector<std::filesystem::path>& inputs);
/// True where both name one file; false where one is empty.
bool same_file(const std::string& a, const std::string& b);
/// The same for a file that is written beside the result, and must not be the result's own; there
/// is none where it is empty.
void check_beside(const OutputOptions& result, const std::string& flag, const std::string& file,
                  const std::vector<std::filesystem::path>& inputs);
/// Writes the result, whole.
void write_result(const OutputOptions& options, const std::string& text);

/// More is a mistake in typing.
inline constexpr unsigned most_threads = 1024;

/// Validators for CLI11 that read numbers the way the rest of the program does.
std::string check_positive(const std::string& text);
std::string check_not_negative(const std::string& text);
std::string check_whole(const std::string& text);
/// A gain of the coupling, by its key: within the range that a scene may give it.
std::function<std::string(const std::string&)> check_gain(const char* key);

}  // namespace sonde::app
