// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {

/// How work in a process of its own ended.
struct ChildEnd {
  std::string output;  ///< what the work returned; not all of it where it did not end well
  int signal = 0;      ///< that ended it; 0: none
  bool threw = false;
};

/// Does work in a copy of this process, for a library that a bad file may crash or abort. Nothing
/// that the work changes is changed here, and what it prints is not shown. The work may allocate;
/// it must not wait for other threads: there are none. Throws Cancelled, with the work ended, where
/// progress returns false (asked every 50 ms); std::system_error where no process can be had.
ChildEnd in_child_process(const std::function<std::string()>& work, const Progress& progress);

}  // namespace sonde
