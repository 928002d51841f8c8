// SPDX-License-Identifier: GPL-3.0-or-later
// Any text as a table of poses, and as a path.
#include "engine/base/error.hpp"
#include "engine/scene/poses.hpp"
#include "tests/fuzz/fuzz.hpp"

namespace {

using namespace sonde;

void check(const Pose& pose) {
  fuzz::require(pose.p.allFinite() && std::abs(pose.q.norm() - 1) < 1e-9, "a pose is a pose");
}

template <class Task>
void quietly(const Task& task) {
  try {
    task();
  } catch (const InputError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::InputFile file(fuzz::text_of(data, size), ".csv");
  quietly([&] {
    for (const Pose& pose : read_poses(file.path())) check(pose);
  });
  quietly([&] {
    double before = -std::numeric_limits<double>::infinity();
    for (const TimedPose& at : read_trajectory(file.path())) {
      check(at.pose);
      fuzz::require(at.t > before, "the times of a path rise");
      before = at.t;
    }
  });
  return 0;
}
