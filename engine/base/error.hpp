// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace sonde {

/// Unusable input. what() is one line: "FILE:LINE: reason", "FILE: byte N: reason" or "FILE:
/// reason". The programs print it and exit with code 3, or show it in a message box.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  /// "FILE:LINE: reason"; lines count from 1.
  static InputError at_line(const std::string& file, std::size_t line, const std::string& reason) {
    return InputError(file + ":" + std::to_string(line) + ": " + reason);
  }
  /// "FILE: byte N: reason"; bytes count from 0.
  static InputError at_byte(const std::string& file, std::size_t byte, const std::string& reason) {
    return InputError(file + ": byte " + std::to_string(byte) + ": " + reason);
  }
  /// "FILE: reason".
  static InputError in(const std::string& file, const std::string& reason) {
    return InputError(file + ": " + reason);
  }
};

/// The user cancelled a long operation; nothing was changed.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Called with the fraction done, 0 to 1; returns false to cancel (the operation throws Cancelled).
using Progress = std::function<bool(double fraction)>;

}  // namespace sonde
