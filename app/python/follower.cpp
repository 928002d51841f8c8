// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/follower.hpp"

#include <pybind11/stl.h>

#include <stdexcept>
#include <vector>

#include "app/python/interruptible.hpp"
#include "app/python/poses.hpp"
#include "app/python/words.hpp"

namespace sonde::python {

namespace py = pybind11;
using namespace py::literals;

PathFollower::PathFollower(const SharedBody& probe, const SharedBody& fixed,
                           const MethodArgument& method, SeedArgument seed)
    : PathFollower(interruptible(py::none(),
                                 [&](Interruptible& state) {
                                   return Pair(probe.body, fixed.body, state.progress());
                                 }),
                   {probe.fingerprint, fixed.fingerprint}, method_of(method), seed) {}
PathFollower::PathFollower(const Pair& pair, const PairMark& mark, Method method,
                           std::uint64_t seed)
    : mark_(mark), method_(method), seed_(seed), follower_(pair, method) {}
PathFollower::PathFollower(const PathFollower& other)
    : mark_(other.mark_),
      method_(other.method_),
      seed_(other.seed_),
      follower_(other.follower_),
      started_(other.started_) {}

Depths PathFollower::follow(const py::object& poses, BudgetSteps budget_steps,
                            BudgetMicroseconds budget_us) {
  const Poses given = poses_of(poses);
  const Budget budget = budget_of(budget_steps, budget_us);
  std::vector<PoseResult> rows;
  rows.reserve(given.rows.size());
  const std::unique_lock<std::mutex> mine = taken();
  interruptible(py::none(), [&](Interruptible& state) {
    const Progress progress = state.progress();
    for (const Pose& pose : given.rows) {
      if (!progress(0)) throw Cancelled();
      rows.emplace_back(next(pose, budget, progress));
    }
    return 0;
  });
  return depths_of(rows, mark_);
}

Found PathFollower::step(const py::object& given, BudgetSteps budget_steps,
                         BudgetMicroseconds budget_us) {
  const Pose pose = pose_of(given);
  const Budget budget = budget_of(budget_steps, budget_us);
  const std::unique_lock<std::mutex> mine = taken();
  if (started_) {
    const py::gil_scoped_release released;
    return {follower_.follow(pose, budget), mark_};
  }
  return interruptible(py::none(), [&](Interruptible& state) {
    return Found(next(pose, budget, state.progress()), mark_);
  });
}

void PathFollower::restart() {
  const std::unique_lock<std::mutex> mine = taken();
  started_ = false;
}

PathFollower PathFollower::copy() {
  const std::unique_lock<std::mutex> mine = taken();
  return *this;
}

/// Waiting would be with the interpreter's lock, which the one who has it needs.
std::unique_lock<std::mutex> PathFollower::taken() {
  std::unique_lock<std::mutex> lock(in_use_, std::try_to_lock);
  if (!lock) throw std::runtime_error("another thread uses this follower");
  return lock;
}

Separation PathFollower::next(const Pose& pose, const Budget& budget, const Progress& progress) {
  if (started_) return follower_.follow(pose, budget);
  const Separation& first =
      follower_.start(pose, {.method = method_, .budget = budget, .seed = seed_}, progress);
  started_ = first.status != Status::failed;
  return first;
}

void declare_follower(py::module_& module) {
  py::class_<PathFollower>(
      module, "Follower",
      "Follows a moving probe, pose by pose along free paths, so the separated\n"
      "pose never pops through. Use it from one thread at a time: a second one is refused\n"
      "with RuntimeError.")
      .def(py::init<const SharedBody&, const SharedBody&, const MethodArgument&, SeedArgument>(),
           "probe"_a, "fixed"_a, "method"_a = "pdg", "seed"_a = 1,
           "Of two bodies that overlap or not. method: \"pdg\" (rigid motions) or \"pdt\"\n"
           "(translations alone); seed: of the search that finds the first separated pose.")
      .def("follow", &PathFollower::follow, "poses"_a, "budget_steps"_a = 0, "budget_us"_a = 0.0,
           "Follows to the next poses, (7,) or (n, 7), or matrices. A search finds the first\n"
           "separated pose.")
      .def("step", &PathFollower::step, "pose"_a, "budget_steps"_a = 0, "budget_us"_a = 0.0,
           "Follows to one pose, and says what it found there: quicker than follow().")
      .def("copy", &PathFollower::copy,
           "A second follower that goes on from the same state, to the same bits.")
      .def("restart", &PathFollower::restart,
           "Starts again: a search finds the next separated pose.");
}

}  // namespace sonde::python
