// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "app/python/arguments.hpp"
#include "app/python/bodies.hpp"
#include "app/python/depths.hpp"
#include "app/python/separations.hpp"

namespace sonde::python {

/// The coherent solver. A search starts it, at the first pose and after each restart(). A second
/// thread that uses it at the same time is refused (std::runtime_error).
class PathFollower {
 public:
  PathFollower(const SharedBody& probe, const SharedBody& fixed, const MethodArgument& method,
               SeedArgument seed);
  PathFollower(const Pair& pair, const PairMark& mark, Method method, std::uint64_t seed);
  /// @pre No other thread uses it.
  PathFollower(const PathFollower& other);

  Depths follow(const pybind11::object& poses, BudgetSteps budget_steps,
                BudgetMicroseconds budget_us);
  Found step(const pybind11::object& pose, BudgetSteps budget_steps, BudgetMicroseconds budget_us);
  void restart();
  PathFollower copy();

 private:
  std::unique_lock<std::mutex> taken();
  Separation next(const Pose& pose, const Budget& budget, const Progress& progress);

  PairMark mark_;
  Method method_;
  std::uint64_t seed_;
  sonde::Follower follower_;
  bool started_ = false;
  std::mutex in_use_;
};

void declare_follower(pybind11::module_& module);

}  // namespace sonde::python

template <>
struct pybind11::detail::type_caster<sonde::python::PathFollower>
    : sonde::python::InitialisedCaster<sonde::python::PathFollower> {};
