// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include "app/python/interruptible.hpp"

namespace sonde::python {

/// How long the work on a row takes.
enum class Takes {
  microseconds,  ///< less than to look at the clock; a single row keeps the interpreter's lock
  milliseconds   ///< up to some dozens
};

/// Calls work(i) for every i below n, in this order. An array's rows are worked on without the
/// interpreter's lock, and Ctrl-C ends that.
inline void for_every_row(std::size_t n, Takes takes, const auto& work) {
  if (n == 1 && takes == Takes::microseconds) return work(0);
  if (n == 1) {
    const pybind11::gil_scoped_release released;
    return work(0);
  }
  const std::size_t between_looks = takes == Takes::microseconds ? 32 : 1;
  interruptible(pybind11::none(), [&](Interruptible& state) {
    const Progress progress = state.progress();
    for (std::size_t i = 0; i < n; ++i) {
      if (i % between_looks == 0 && !progress(0)) throw Cancelled();
      work(i);
    }
    return 0;
  });
}

}  // namespace sonde::python
