// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/pairs.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <optional>
#include <utility>

#include "app/python/arguments.hpp"
#include "app/python/bodies.hpp"
#include "app/python/depths.hpp"
#include "app/python/every_pose.hpp"
#include "app/python/every_row.hpp"
#include "app/python/follower.hpp"
#include "app/python/interruptible.hpp"
#include "app/python/poses.hpp"
#include "app/python/restricted.hpp"
#include "app/python/separations.hpp"
#include "app/python/shared_pair.hpp"
#include "app/python/words.hpp"
#include "app/python/wrenches.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

SharedPair pair_of(const SharedBody& probe, const SharedBody& fixed) {
  return {probe, fixed, interruptible(py::none(), [&](Interruptible& state) {
            return Pair(probe.body, fixed.body, state.progress());
          })};
}

/// What is asked of a search, by the words of Python's arguments.
struct SearchWish {
  StaticOptions options;
  std::optional<Knob> knob;
  unsigned threads = 0;
};

Depths searched(const SharedPair& pair, const std::vector<Pose>& poses, const SearchWish& search,
                const py::object& told) {
  const auto answer = [&](const Pose& pose, const Progress& progress) -> PoseResult {
    StaticOptions own = search.options;
    own.seed = seed_of_pose(search.options.seed, pose);
    if (search.knob) return separate(pair.pair, pose, *search.knob, own.method, own.seed);
    own.two_threads = search.threads != 1 && poses.size() == 1;
    return separate(pair.pair, pose, own, progress);
  };
  return depths_of(of_every_pose<PoseResult>(poses, search.threads, told, answer), pair.mark());
}

void need_share(const char* name, double given) {
  if (!(given > 0 && given < 1))
    throw std::invalid_argument(std::string(name) + " must be above 0 and below 1");
}

SearchWish search_of(const std::string& method, std::uint64_t seed, unsigned threads,
                     int budget_steps, double budget_us, bool whole_bound, bool clearance,
                     std::optional<double> time, std::optional<double> accuracy, double sure) {
  SearchWish out;
  out.options.method = method_of(method);
  out.options.budget = budget_of(budget_steps, budget_us);
  out.options.seed = seed;
  out.options.sure = sure;
  out.options.whole_bound = whole_bound;
  out.options.share_for_bound = whole_bound ? 0.3 : 0;
  out.options.want_clearance = clearance;
  out.threads = threads;
  need_share("sure", sure);
  if (accuracy) need_share("accuracy", *accuracy);
  if (time && (!(*time > 0) || !std::isfinite(*time)))
    throw std::invalid_argument("time must be above 0 and finite, in seconds");
  if (time && accuracy)
    throw std::invalid_argument("give time or accuracy: the one follows from the other");
  if (time || accuracy) {
    if (budget_steps > 0 || budget_us > 0 || whole_bound)
      throw std::invalid_argument("time and accuracy are budgets, without a bound: give no other");
    out.knob = Knob{.time = time.value_or(0), .accuracy = accuracy.value_or(0), .sure = sure};
  }
  return out;
}

Depths pair_depth(const SharedPair& pair, const py::object& poses, const MethodArgument& method,
                  SeedArgument seed, ThreadsArgument threads, BudgetSteps budget_steps,
                  BudgetMicroseconds budget_us, WholeBound whole_bound, WantClearance clearance,
                  TimeArgument time, AccuracyArgument accuracy, SureArgument sure,
                  const py::object& progress) {
  return searched(pair, poses_of(poses).rows,
                  search_of(method, seed, threads, budget_steps, budget_us, whole_bound, clearance,
                            time, accuracy, sure),
                  progress);
}

Depths depth(const SharedBody& probe, const SharedBody& fixed, const py::object& poses,
             const MethodArgument& method, SeedArgument seed, ThreadsArgument threads,
             BudgetSteps budget_steps, BudgetMicroseconds budget_us, WholeBound whole_bound,
             WantClearance clearance, TimeArgument time, AccuracyArgument accuracy,
             SureArgument sure, const py::object& progress) {
  const Poses given = poses_of(poses);
  const SearchWish search = search_of(method, seed, threads, budget_steps, budget_us, whole_bound,
                                      clearance, time, accuracy, sure);
  return searched(pair_of(probe, fixed), given.rows, search, progress);
}

/// Not where that cannot be told: separate() says why.
bool is_free(const Pair& pair, const Pose& pose) {
  try {
    return !touch(pair, pose);
  } catch (const InputError&) {
    return false;
  }
}

Found pair_separate(const SharedPair& pair, const py::object& given, const MethodArgument& method,
                    SeedArgument seed, WantClearance clearance) {
  const Pose pose = pose_of(given);
  // Most free poses are so in less time than other threads take to give the interpreter's lock
  // back.
  if (!clearance && is_free(pair.pair, pose)) return {separate(pair.pair, pose), pair.mark()};
  StaticOptions options{.method = method_of(method), .seed = seed_of_pose(seed, pose)};
  options.want_clearance = clearance;
  options.two_threads = true;
  return interruptible(py::none(), [&](Interruptible& state) {
    return Found(separate(pair.pair, pose, options, state.progress()), pair.mark());
  });
}

py::object pair_touch(const SharedPair& pair, const py::object& given) {
  const Poses poses = poses_of(given);
  if (poses.one) return py::bool_(touch(pair.pair, poses.rows[0]));
  py::array_t<bool> out(static_cast<py::ssize_t>(poses.rows.size()));
  for_every_row(poses.rows.size(), Takes::microseconds,
                [&, to = out.mutable_data()](auto i) { to[i] = touch(pair.pair, poses.rows[i]); });
  return out;
}

/// An array of a row for each, or for a single one what is in its row.
py::object unless_one(const py::object& rows, bool one) {
  return one ? py::object(rows[py::int_(0)]) : rows;
}
auto vectors(std::size_t n, const auto& vector_of) {
  return rows_of(n, 3, [&](std::size_t i, std::size_t j) {
    return vector_of(i)[static_cast<Eigen::Index>(j)];
  });
}

py::tuple pair_distance(const SharedPair& pair, const py::object& given) {
  const Poses poses = poses_of(given);
  std::vector<Clearance> found(poses.rows.size());
  for_every_row(found.size(), Takes::milliseconds,
                [&](auto i) { found[i] = distance(pair.pair, poses.rows[i]); });
  const std::size_t n = found.size();
  return py::make_tuple(
      unless_one(rows_of(n, 1, [&](std::size_t i, std::size_t) { return found[i].distance; }),
                 poses.one),
      unless_one(vectors(n, [&](std::size_t i) -> const Vec3& { return found[i].on_probe; }),
                 poses.one),
      unless_one(vectors(n, [&](std::size_t i) -> const Vec3& { return found[i].on_fixed; }),
                 poses.one));
}

py::object pair_signed_distance(const SharedPair& pair, const py::object& given,
                                const MethodArgument& method, SeedArgument seed,
                                ThreadsArgument threads, const py::object& progress) {
  const Poses poses = poses_of(given);
  const StaticOptions options{.method = method_of(method), .seed = seed, .want_lower_bound = false};
  const auto found = of_every_pose<double>(
      poses.rows, threads, progress, [&](const Pose& pose, const Progress& told) {
        StaticOptions own = options;
        own.seed = seed_of_pose(seed, pose);
        return signed_distance(pair.pair, pose, own, told).distance;
      });
  return unless_one(rows_of(found.size(), 1, [&](std::size_t i, std::size_t) { return found[i]; }),
                    poses.one);
}

/// How far motions are free.
py::tuple pair_sweep(const SharedPair& pair, const py::object& start, const py::object& end) {
  const Poses from = poses_of(start, "start"), to = poses_of(end, "end");
  if (from.rows.size() != to.rows.size())
    throw std::invalid_argument("start and end must be as many");
  std::vector<SweptPath> found(from.rows.size());
  for_every_row(found.size(), Takes::milliseconds,
                [&](auto i) { found[i] = sweep(pair.pair, from.rows[i], to.rows[i]); });
  const std::size_t n = found.size();
  const bool one = from.one && to.one;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto contact = [&](Vec3 Contact::*member) {
    return vectors(n, [&, member](std::size_t i) -> Vec3 {
      const bool is_there = found[i].hit && !found[i].overlapping;
      return is_there ? Vec3(found[i].contact.*member) : Vec3(Vec3::Constant(none));
    });
  };
  return py::make_tuple(
      unless_one(rows_of(n, 1, [&](std::size_t i, std::size_t) { return found[i].free; }), one),
      unless_one(
          rows_of(n, 7, [&](std::size_t i, std::size_t j) { return numbers_of(found[i].X_FM)[j]; }),
          one),
      unless_one(contact(&Contact::on_fixed), one), unless_one(contact(&Contact::normal), one));
}

constexpr const char* depth_words =
    "The penetration depth of the probe at each of the poses, (7,) or (n, 7):\n"
    "px,py,pz,qw,qx,qy,qz, or matrices, (4, 4) or (n, 4, 4): the probe's mesh frame in\n"
    "the fixed body's, metres.\n"
    "Searches each pose by itself, on `threads` threads (0: all of the machine's).\n"
    "The number of threads does not change the results. They are the same bits as\n"
    "those of `sonde query`, and with `whole_bound` those of `sonde query --bound`:\n"
    "a lower bound that may take longer than the search. clearance: say how far apart\n"
    "the bodies are where they are. time (s) or accuracy: for each pose, as of\n"
    "`sonde query --time` and `--accuracy`; sure: the share that is to keep its claim.\n"
    "progress: called with the fraction done; where it returns False, Cancelled is raised.";

}  // namespace

void declare_pair(py::module_& module) {
  declare_follower(module);
  PairClass declared(module, "Pair",
                     "The probe and the fixed body, with what is computed once for both (10 to\n"
                     "200 ms): make one where many queries are to come.");
  declared.def(py::init(&pair_of), "probe"_a, "fixed"_a, "Of two bodies.")
      .def_readonly("probe", &SharedPair::probe, "The moving body.")
      .def_readonly("fixed", &SharedPair::fixed, "The body that stays.")
      .def("depth", &pair_depth, "poses"_a, py::kw_only(), "method"_a = "pdg", "seed"_a = 1,
           "threads"_a = 0, "budget_steps"_a = 0, "budget_us"_a = 0.0, "whole_bound"_a = false,
           "clearance"_a = false, "time"_a = py::none(), "accuracy"_a = py::none(), "sure"_a = 0.9,
           "progress"_a = py::none(), depth_words)
      .def("separate", &pair_separate, "pose"_a, py::kw_only(), "method"_a = "pdg", "seed"_a = 1,
           "clearance"_a = false, "The same of one pose: quicker where it is free.")
      .def("touch", &pair_touch, "poses"_a,
           "Whether the bodies touch or overlap: bool, or an array of a row for each pose.")
      .def("distance", &pair_distance, "poses"_a,
           "How far the bodies are apart, m, 0 where they touch or overlap, and the points of\n"
           "probe and fixed body where it is taken: (n,), (n, 3), (n, 3).")
      .def("signed_distance", &pair_signed_distance, "poses"_a, py::kw_only(), "method"_a = "pdg",
           "seed"_a = 1, "threads"_a = 0, "progress"_a = py::none(),
           "The distance where the bodies are apart and less than 0, by the depth, where not, m.")
      .def("sweep", &pair_sweep, "start"_a, "end"_a,
           "How far the motion from start to end is free, 0 to 1, the pose there, and the point\n"
           "and normal of the contact: (n,), (n, 7), (n, 3), (n, 3); NaN without one. The centre\n"
           "of mass goes along a line, the turn about one axis.")
      .def(
          "follower",
          [](const SharedPair& pair, const MethodArgument& method, SeedArgument seed) {
            return PathFollower(pair.pair, pair.mark(), method_of(method), seed);
          },
          "method"_a = "pdg", "seed"_a = 1, "A follower of the pair.")
      .def(
          "write", [](const SharedPair& p, const FileArgument& file) { write_pair(file, p.pair); },
          "file"_a, "Keeps what was computed for both bodies in a file, 0.4 to 1.1 MB.")
      .def_static(
          "read",
          [](const FileArgument& file, const SharedBody& probe, const SharedBody& fixed) {
            return SharedPair{probe, fixed, read_pair(file, probe.body, fixed.body)};
          },
          "file"_a, "probe"_a, "fixed"_a,
          "The pair of these bodies with what write() kept: the same bits as of one made anew.\n"
          "InputError where the file was written for other bodies or by another version.")
      .def("__repr__",
           [](const SharedPair& p) {
             return "<sonde.Pair of " + p.probe.facts.name + " and " + p.fixed.facts.name + ">";
           })
      .def(py::pickle([](const SharedPair& p) { return py::make_tuple(p.probe, p.fixed); },
                      [](const py::tuple& state) {
                        return pair_of(state[0].cast<const SharedBody&>(),
                                       state[1].cast<const SharedBody&>());
                      }));
  declare_wrenches(module, declared);
  declare_restricted(declared);
  module.def("depth", &depth, "probe"_a, "fixed"_a, "poses"_a, py::kw_only(), "method"_a = "pdg",
             "seed"_a = 1, "threads"_a = 0, "budget_steps"_a = 0, "budget_us"_a = 0.0,
             "whole_bound"_a = false, "clearance"_a = false, "time"_a = py::none(),
             "accuracy"_a = py::none(), "sure"_a = 0.9, "progress"_a = py::none(), depth_words);
  module.def("touch", &pair_touch, "pair"_a, "poses"_a, "As Pair.touch.");
  module.def("distance", &pair_distance, "pair"_a, "poses"_a, "As Pair.distance.");
  module.def("signed_distance", &pair_signed_distance, "pair"_a, "poses"_a, py::kw_only(),
             "method"_a = "pdg", "seed"_a = 1, "threads"_a = 0, "progress"_a = py::none(),
             "As Pair.signed_distance.");
  module.def("sweep", &pair_sweep, "pair"_a, "start"_a, "end"_a, "As Pair.sweep.");
}

}  // namespace sonde::python
