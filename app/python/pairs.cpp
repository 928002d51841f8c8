// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/pairs.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "app/python/bodies.hpp"
#include "app/python/depths.hpp"
#include "app/python/follower.hpp"
#include "app/python/interruptible.hpp"
#include "app/python/poses.hpp"
#include "app/python/words.hpp"
#include "engine/base/threads.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

constexpr unsigned most_threads = 1024;

/// Two bodies, with what is computed once for both.
struct SharedPair {
  SharedBody probe, fixed;
  Pair pair;
};

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

std::size_t threads_of(unsigned asked) {
  return std::clamp(asked == 0 ? std::thread::hardware_concurrency() : asked, 1U, most_threads);
}

/// depth() of all poses, on threads of its own: each thread's progress looks whether it is to end.
template <class Result>
std::vector<Result> all_of(const std::vector<Pose>& poses, unsigned threads, const py::object& told,
                           const auto& answer) {
  std::vector<Result> rows(poses.size());
  interruptible(told, [&](Interruptible& state) {
    std::atomic<std::size_t> done{0};
    const double n = static_cast<double>(std::max<std::size_t>(1, poses.size()));
    run_parallel(poses.size(), threads_of(threads), [&](std::size_t i) {
      const Progress progress = state.progress(
          [&](double part) { return std::min(1.0, (static_cast<double>(done) + part) / n); });
      if (!progress(0)) throw Cancelled();
      rows[i] = answer(poses[i], progress);
      ++done;
    });
    return 0;
  });
  return rows;
}

Depths searched(const Pair& pair, const std::vector<Pose>& poses, const SearchWish& search,
                const py::object& told) {
  if (search.knob)
    return depths_of(
        all_of<Answer>(poses, search.threads, told, [&](const Pose& pose, const Progress&) {
          return separate(pair, pose, *search.knob, search.options.method,
                          seed_of_pose(search.options.seed, pose));
        }));
  return depths_of(all_of<Separation>(poses, search.threads, told,
                                      [&](const Pose& pose, const Progress& progress) {
                                        StaticOptions own = search.options;
                                        own.seed = seed_of_pose(search.options.seed, pose);
                                        own.two_threads = search.threads != 1 && poses.size() == 1;
                                        return separate(pair, pose, own, progress);
                                      }));
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
  if (time || accuracy) {
    if (budget_steps > 0 || budget_us > 0 || whole_bound)
      throw std::invalid_argument("time and accuracy are budgets, without a bound: give no other");
    out.knob = Knob{.time = time.value_or(0), .accuracy = accuracy.value_or(0), .sure = sure};
  }
  return out;
}

Depths pair_depth(const SharedPair& pair, const py::object& poses, const std::string& method,
                  std::uint64_t seed, unsigned threads, int budget_steps, double budget_us,
                  bool whole_bound, bool clearance, std::optional<double> time,
                  std::optional<double> accuracy, double sure, const py::object& progress) {
  return searched(pair.pair, poses_of(poses).rows,
                  search_of(method, seed, threads, budget_steps, budget_us, whole_bound, clearance,
                            time, accuracy, sure),
                  progress);
}

Depths depth(const SharedBody& probe, const SharedBody& fixed, const py::object& poses,
             const std::string& method, std::uint64_t seed, unsigned threads, int budget_steps,
             double budget_us, bool whole_bound, bool clearance, std::optional<double> time,
             std::optional<double> accuracy, double sure, const py::object& progress) {
  const Poses given = poses_of(poses);
  const SearchWish search = search_of(method, seed, threads, budget_steps, budget_us, whole_bound,
                                      clearance, time, accuracy, sure);
  return searched(pair_of(probe, fixed).pair, given.rows, search, progress);
}

Separation pair_separate(const SharedPair& pair, const py::object& given, const std::string& method,
                         std::uint64_t seed, bool clearance) {
  const Pose pose = pose_of(given);
  // Most free poses are so in less time than a progress takes to be made.
  if (!clearance && !touch(pair.pair, pose)) return separate(pair.pair, pose);
  StaticOptions options{.method = method_of(method), .seed = seed_of_pose(seed, pose)};
  options.want_clearance = clearance;
  options.two_threads = true;
  return interruptible(py::none(), [&](Interruptible& state) {
    return separate(pair.pair, pose, options, state.progress());
  });
}

py::object pair_touch(const SharedPair& pair, const py::object& given) {
  const Poses poses = poses_of(given);
  if (poses.one) return py::bool_(touch(pair.pair, poses.rows[0]));
  py::array_t<bool> out(static_cast<py::ssize_t>(poses.rows.size()));
  bool* to = out.mutable_data();
  {
    const py::gil_scoped_release released;
    for (const Pose& pose : poses.rows) *to++ = touch(pair.pair, pose);
  }
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
  std::vector<Clearance> found;
  {
    const py::gil_scoped_release released;
    for (const Pose& pose : poses.rows) found.push_back(distance(pair.pair, pose));
  }
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
                                const std::string& method, std::uint64_t seed, unsigned threads,
                                const py::object& progress) {
  const Poses poses = poses_of(given);
  const StaticOptions options{.method = method_of(method), .seed = seed, .want_lower_bound = false};
  const auto found =
      all_of<double>(poses.rows, threads, progress, [&](const Pose& pose, const Progress& told) {
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
  std::vector<SweptPath> found;
  {
    const py::gil_scoped_release released;
    for (std::size_t i = 0; i < from.rows.size(); ++i)
      found.push_back(sweep(pair.pair, from.rows[i], to.rows[i]));
  }
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

/// The wrench of rows of Depths: of their poses alone, as the coupling does without damping.
py::array_t<double> pair_wrench(const SharedPair& pair, const py::object& of, double k,
                                const std::string& mode, double k_t, double k_r, double max_force,
                                double max_torque) {
  Coupling coupling;
  coupling.mode = chosen<Coupling::Mode>(
      "mode", mode, {{"object", Coupling::Mode::object}, {"classic", Coupling::Mode::classic}});
  coupling.k = k, coupling.k_t = k_t, coupling.k_r = k_r;
  coupling.b_t = coupling.b_r = 0;
  coupling.max_force = max_force, coupling.max_torque = max_torque;
  for (const double x : {k, k_t, k_r})
    if (!std::isfinite(x) || x < 0)
      throw std::invalid_argument("a stiffness must be finite, 0 or more");
  for (const double x : {max_force, max_torque})
    if (!(x >= 0)) throw std::invalid_argument("a limit must be 0 or more");
  std::vector<Separation> rows;
  if (py::isinstance<Separation>(of)) {
    rows.push_back(of.cast<const Separation&>());
  } else if (py::isinstance<Depths>(of)) {
    const auto& depths = of.cast<const Depths&>();
    const auto status = depths.status.attr("tolist")().cast<std::vector<std::string>>();
    for (std::size_t i = 0; i < status.size(); ++i) {
      Separation s;
      s.status = status[i] == "penetrating" ? Status::penetrating
                 : status[i] == "separated" ? Status::separated
                                            : Status::failed;
      const auto pose = [&](const py::array_t<double>& all) {
        const double* n = all.data() + 7 * i;
        return Pose{Quat(n[3], n[4], n[5], n[6]), Vec3(n[0], n[1], n[2])};
      };
      s.device = pose(depths.device);
      s.separated = pose(depths.pose);
      rows.push_back(s);
    }
  } else {
    throw std::invalid_argument("of must be Depths or a Separation");
  }
  std::vector<Wrench> felt;
  felt.reserve(rows.size());
  for (const Separation& row : rows) felt.push_back(wrench(pair.pair, row, coupling));
  return rows_of(rows.size(), 6, [&](std::size_t i, std::size_t j) {
    const auto axis = static_cast<Eigen::Index>(j % 3);
    return j < 3 ? felt[i].force[axis] : felt[i].torque[axis];
  });
}

/// d(depth), d(wrench) on either side, and which sides there are.
py::tuple pair_derivative(const SharedPair& pair, const Separation& of) {
  const WrenchDerivative d = wrench_derivative(pair.pair, of, Neighbours::all);
  const auto matrix = [](const WrenchDerivative::Matrix& m) {
    return rows_of(6, 6, [&](std::size_t i, std::size_t j) {
      return m(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    });
  };
  const char* sides = d.sides == WrenchDerivative::Sides::all   ? "all"
                      : d.sides == WrenchDerivative::Sides::two ? "two"
                                                                : "none";
  return py::make_tuple(py::array_t<double>(6, d.d_depth.data()), matrix(d.d_wrench),
                        matrix(d.d_wrench_held), sides);
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
  py::class_<SharedPair>(
      module, "Pair",
      "The probe and the fixed body, with what is computed once for both (10 to\n"
      "200 ms): make one where many queries are to come.")
      .def(py::init(&pair_of), "probe"_a, "fixed"_a, "Of two bodies.")
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
          "wrench", &pair_wrench, "of"_a, "k"_a = 1000.0, "mode"_a = "object", "k_t"_a = 1000.0,
          "k_r"_a = 1.0, "max_force"_a = 1e30, "max_torque"_a = 1e30,
          "Force (N) and torque (N m, about the probe's centre of mass) on the hand, in the fixed\n"
          "frame, (n, 6), of Depths or a Separation of this pair. mode \"object\": k in N/m;\n"
          "\"classic\": k_t in N/m and k_r in N m/rad, without damping.")
      .def("derivative", &pair_derivative, "of"_a,
           "How the depth (6,) and the wrench (6, 6), at k = 1, of a Separation of this pair "
           "change\n"
           "with its pose: by a displacement of the probe's centre of mass, m, and a rotation\n"
           "vector, rad, in the fixed frame. Then the wrench's on the other side, and \"all\" "
           "where\n"
           "both are one, \"two\" where contacts begin or end at this pose, or \"none\" where "
           "there\n"
           "is no derivative.")
      .def(
          "follower",
          [](const SharedPair& pair, const std::string& method, std::uint64_t seed) {
            return PathFollower(pair.pair, method_of(method), seed);
          },
          "method"_a = "pdg", "seed"_a = 1, "A follower of the pair.")
      .def("__repr__",
           [](const SharedPair& p) {
             return "<sonde.Pair of " + p.probe.facts.name + " and " + p.fixed.facts.name + ">";
           })
      .def(py::pickle([](const SharedPair& p) { return py::make_tuple(p.probe, p.fixed); },
                      [](const py::tuple& state) {
                        return pair_of(state[0].cast<const SharedBody&>(),
                                       state[1].cast<const SharedBody&>());
                      }));
  module.def("depth", &depth, "probe"_a, "fixed"_a, "poses"_a, py::kw_only(), "method"_a = "pdg",
             "seed"_a = 1, "threads"_a = 0, "budget_steps"_a = 0, "budget_us"_a = 0.0,
             "whole_bound"_a = false, "clearance"_a = false, "time"_a = py::none(),
             "accuracy"_a = py::none(), "sure"_a = 0.9, "progress"_a = py::none(), depth_words);
  module.def("touch", &pair_touch, "pair"_a, "poses"_a, "As Pair.touch.");
  module.def("distance", &pair_distance, "pair"_a, "poses"_a, "As Pair.distance.");
  module.def("sweep", &pair_sweep, "pair"_a, "start"_a, "end"_a, "As Pair.sweep.");
  module.def("wrench", &pair_wrench, "pair"_a, "of"_a, "k"_a = 1000.0, "mode"_a = "object",
             "k_t"_a = 1000.0, "k_r"_a = 1.0, "max_force"_a = 1e30, "max_torque"_a = 1e30,
             "As Pair.wrench.");
}

}  // namespace sonde::python
