// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/restricted.hpp"

#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/depths.hpp"
#include "app/python/every_pose.hpp"
#include "app/python/poses.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

Vec3 vector_of(const py::object& given, const char* what) {
  const Points points = points_of(given, what);
  if (!points.one) throw std::invalid_argument(std::string(what) + " must be one, of shape (3,)");
  return points.rows[0];
}

Depths of_all(const SharedPair& pair, const py::object& poses, unsigned threads,
              const py::object& told, const auto& answer) {
  return depths_of(of_every_pose<PoseResult>(poses_of(poses).rows, threads, told, answer),
                   pair.mark());
}

Depths depth_along(const SharedPair& pair, const py::object& poses, const py::object& directions,
                   ThreadsArgument threads, const py::object& progress) {
  const std::vector<Vec3> ways = points_of(directions, "directions").rows;
  return of_all(pair, poses, threads, progress, [&](const Pose& pose, const Progress& told) {
    return separate_along(pair.pair, pose, ways, told);
  });
}

Depths depth_about(const SharedPair& pair, const py::object& poses, const py::object& point,
                   const py::object& axis, ThreadsArgument threads, const py::object& progress) {
  const Vec3 on_it = vector_of(point, "point"), along = vector_of(axis, "axis");
  return of_all(pair, poses, threads, progress, [&](const Pose& pose, const Progress& told) {
    return separate_about(pair.pair, pose, on_it, along, told);
  });
}

Depths depth_in_plane(const SharedPair& pair, const py::object& poses, const py::object& normal,
                      Argument<"turning", bool> turning, SeedArgument seed, ThreadsArgument threads,
                      const py::object& progress) {
  const InPlane motions{vector_of(normal, "normal"), turning};
  return of_all(pair, poses, threads, progress, [&](const Pose& pose, const Progress& told) {
    const StaticOptions options{.seed = seed_of_pose(seed, pose)};
    return separate_in_plane(pair.pair, pose, motions, options, told);
  });
}

}  // namespace

void declare_restricted(PairClass& pair) {
  pair.def("depth_along", &depth_along, "poses"_a, "directions"_a, py::kw_only(), "threads"_a = 0,
           "progress"_a = py::none(),
           "The depth along directions of the fixed frame, (3,) or (n, 3), each one way only: the\n"
           "least of all these ways out, found exactly but for rounding. Depths as of depth().")
      .def("depth_about", &depth_about, "poses"_a, "point"_a, "axis"_a, py::kw_only(),
           "threads"_a = 0, "progress"_a = py::none(),
           "The depth of the least turn about an axis through a point, both in the fixed frame,\n"
           "to either side; \"failed\" where no turn sets the probe free.")
      .def("depth_in_plane", &depth_in_plane, "poses"_a, "normal"_a, py::kw_only(),
           "turning"_a = true, "seed"_a = 1, "threads"_a = 0, "progress"_a = py::none(),
           "The depth among motions in the plane of a normal (fixed frame): slides, and with\n"
           "turning also turns about the normal. An upper bound, as that of depth().");
}

}  // namespace sonde::python
