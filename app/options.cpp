// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/options.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "app/interrupt.hpp"
#include "engine/base/error.hpp"
#include "engine/platform/writable_file.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::app {
namespace {

std::string flag_of(const Setting& setting) {
  std::string flag = std::string("--") + setting.key;
  std::ranges::replace(flag, '_', '-');
  return flag;
}

/// Empty, or what is wrong with a number given on the command line.
template <class Test>
std::string check_number(const std::string& text, const Test& test, const std::string& expected) {
  const auto value = parse_number(text);
  return value && test(*value) ? "" : "\"" + text + "\" must be " + expected;
}

}  // namespace

std::string check_positive(const std::string& text) {
  return check_number(
      text, [](double x) { return std::isfinite(x) && x > 0; }, "a number above zero");
}
std::string check_not_negative(const std::string& text) {
  return check_number(
      text, [](double x) { return std::isfinite(x) && x >= 0; }, "a number, zero or more");
}
std::string check_whole(const std::string& text) {
  std::uint64_t value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = end.ec == std::errc{} && end.ptr == text.data() + text.size();
  return whole ? "" : "\"" + text + "\" must be a whole number, zero or more, below 2^64";
}

std::function<std::string(const std::string&)> check_gain(const char* key) {
  const Setting& setting = *find_setting(coupling_settings(), key);
  return [&setting](const std::string& text) {
    return check_number(
        text, [&](double x) { return allowed(setting, x); }, range_text(setting));
  };
}

void add_flags(CLI::App& parser, SolverOptions& options, const std::string& default_mode) {
  options.mode = default_mode;
  parser.add_option("--method", options.method, "pdg: all six degrees; pdt: translation only")
      ->check(CLI::IsMember(method_names))
      ->capture_default_str();
  parser
      .add_option("--mode", options.mode,
                  "static: searches each pose by itself; coherent: follows each from the last")
      ->check(CLI::IsMember({"static", "coherent"}))
      ->capture_default_str();
  parser
      .add_option("--budget-us", options.budget.microseconds,
                  "wall-clock limit for each pose, µs; 0: until converged")
      ->check(check_not_negative)
      ->capture_default_str();
  parser
      .add_option("--budget-steps", options.budget.steps,
                  "limit on counted iterations for each pose; 0: until converged")
      ->check(check_whole)
      ->capture_default_str();
  parser.add_flag_callback(
      "--bound", [&options] { options.bound = true; },
      "the whole certified lower bound, which may take longer than the search; it gets 0.3 of a "
      "limited time. Without this flag: what can be had in as much work as the search takes");
  parser
      .add_flag_callback(
          "--no-bound", [&options] { options.bound = false; }, "no lower bound")
      ->excludes("--bound");
  parser.add_option("--seed", options.seed, "seed of the searches' random starts")
      ->check(check_whole)
      ->capture_default_str();
  parser
      .add_option("--threads", options.threads,
                  "threads to search on, two for each pose; 0: all of the machine's")
      ->check(check_whole)
      ->check(CLI::Range(0U, most_threads))
      ->capture_default_str();
}

void add_flags(CLI::App& parser, OutputOptions& options) {
  parser.add_option("--out", options.out, "file to write, whole or not at all; -: standard output")
      ->capture_default_str();
  parser.add_flag("--json", options.json, "write JSON instead of CSV");
  parser.add_flag("--quiet", options.quiet, "no progress and no notes on stderr, only failures");
}

void add_setting_flags(CLI::App& parser, std::span<const Setting> settings, SettingValues& values) {
  for (const Setting& setting : settings) {
    const std::string unit = *setting.unit != 0 ? std::string(setting.unit) + ". " : "";
    parser
        .add_option_function<double>(
            flag_of(setting),
            [&values, key = setting.key](const double& value) { values[key] = value; },
            unit + setting.doc)
        ->check([&setting](const std::string& text) {
          return check_number(
              text, [&](double x) { return allowed(setting, x); }, range_text(setting));
        })
        ->group("Settings that replace the scene's");
  }
}

void check_output(const OutputOptions& options, const std::vector<std::filesystem::path>& inputs) {
  if (options.to_file()) check_output("--out", options.out, inputs);
}

void check_output(const std::string& flag, const std::string& file,
                  const std::vector<std::filesystem::path>& inputs) {
  std::error_code error;
  const auto is_it = [&](const auto& input) {
    return std::filesystem::equivalent(file, input, error);
  };
  if (std::ranges::any_of(inputs, is_it))
    throw UsageError(flag + " " + file + " is one of the inputs; it would be overwritten");
  check_writable(file);
}

bool same_file(const std::string& a, const std::string& b) {
  const auto place = [](const std::string& name) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(name));
  };
  return !a.empty() && !b.empty() && place(a) == place(b);
}

void check_beside(const OutputOptions& result, const std::string& flag, const std::string& file,
                  const std::vector<std::filesystem::path>& inputs) {
  if (file.empty()) return;
  check_output(flag, file, inputs);
  if (result.to_file() && same_file(file, result.out))
    throw UsageError(flag + " and --out name the same file: " + file);
}

void write_result(const OutputOptions& options, const std::string& text) {
  finish_despite_interrupts();
  if (options.to_file()) return write_whole(options.out, text);
  if (const int error = write_standard_output(text); error != 0)
    throw InputError::in("standard output",
                         "cannot be written: " + std::generic_category().message(error));
}

}  // namespace sonde::app
