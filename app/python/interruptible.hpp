// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "engine/base/error.hpp"

namespace sonde::python {

/// Refuses what cannot be called.
inline void need_callable(const pybind11::object& told) {
  if (!told.is_none() && PyCallable_Check(told.ptr()) == 0)
    throw pybind11::type_error(std::string("progress must be a function or None, not ") +
                               Py_TYPE(told.ptr())->tp_name);
}

/// Long work that Ctrl-C ends, and that tells a function of Python's how far it is. It is made, and
/// its progress asked for, without the interpreter's lock.
class Interruptible {
 public:
  /// `told`: called with a fraction, 0 to 1, ten times a second at most, on the thread that made
  /// this; where it returns False the work ends. None: nothing is told.
  explicit Interruptible(const pybind11::object& told) : told_(told) {}

  /// For one piece of the work, on any thread: the whole has come to `fraction_of`(fraction).
  template <class Fraction>
  Progress progress(Fraction fraction_of) {
    return [this, fraction_of](double fraction) {
      if (std::this_thread::get_id() == owner_) look(fraction_of(fraction));
      return !stopped_.load(std::memory_order_relaxed);
    };
  }
  Progress progress() {
    return progress([](double fraction) { return fraction; });
  }

  /// With the lock, after the work was Cancelled: throws what Python raised meanwhile, or
  /// KeyboardInterrupt's like.
  void rethrow() {
    if (raised_) raised_->restore();
    if (raised_) throw pybind11::error_already_set();
  }

 private:
  void look(double fraction) {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    const pybind11::gil_scoped_acquire lock;
    try {
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      if (!told_.is_none() && told_(fraction).is(pybind11::bool_(false))) stopped_ = true;
    } catch (pybind11::error_already_set& error) {
      raised_ = std::make_unique<pybind11::error_already_set>(std::move(error));
      stopped_ = true;
    }
  }

  const pybind11::object& told_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  std::atomic<bool> stopped_{false};
  std::unique_ptr<pybind11::error_already_set> raised_;
};

/// Does work(Interruptible&) without the interpreter's lock. Throws what Python raised meanwhile,
/// and Cancelled where the told function ended it.
template <class Work>
auto interruptible(const pybind11::object& told, const Work& work) {
  need_callable(told);
  Interruptible state(told);
  try {
    const pybind11::gil_scoped_release released;
    return work(state);
  } catch (const Cancelled&) {
    state.rethrow();
    throw;
  }
}

}  // namespace sonde::python
