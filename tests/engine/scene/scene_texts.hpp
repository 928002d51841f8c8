// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sonde::test {

inline constexpr const char* smallest =
    R"({"probe": {"mesh": "a.off"}, "fixed": {"mesh": "b.off"}})";

/// A scene that is right but for one more line, line 4.
inline std::string with_line(const std::string& line) {
  return "{\n\"probe\": {\"mesh\": \"a.off\"},\n\"fixed\": {\"mesh\": \"b.off\"},\n" + line +
         "\n}\n";
}
/// A scene whose probe has one more line, line 4.
inline std::string with_probe_line(const std::string& line) {
  return "{\n\"fixed\": {\"mesh\": \"b.off\"},\n\"probe\": {\"mesh\": \"a.off\",\n" + line +
         "\n}}\n";
}

}  // namespace sonde::test
