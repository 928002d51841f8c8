// SPDX-License-Identifier: GPL-3.0-or-later
// The compiled part of the Python module: bodies, depths and followers over NumPy arrays. All work
// is done with the GIL released; depth() is what `sonde query` does, to the bit.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>

#include "app/python/depths.hpp"
#include "app/static_searches.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace sonde::python {
namespace {

using Faces = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

/// pybind11 keeps no pointer to const.
struct SharedBody {
  std::shared_ptr<const sonde::Body> body;
  BodyFacts facts;
};

template <class Value>
Value chosen(const std::string& what, const std::string& word,
             const std::vector<std::pair<std::string, Value>>& known) {
  std::string words;
  for (const auto& [name, value] : known) {
    if (name == word) return value;
    words += (words.empty() ? "" : ", ") + name;
  }
  throw std::invalid_argument(what + " is \"" + word + "\"; it is one of " + words);
}
Model model_of(const std::string& word) {
  return chosen<Model>(
      "model", word,
      {{"auto", Model::automatic}, {"solid", Model::solid}, {"surface", Model::surface}});
}

Repair repair_of(const std::string& word) {
  return chosen<Repair>("repair", word, {{"auto", Repair::automatic}, {"none", Repair::none}});
}
Method method_of(const std::string& word) {
  return chosen<Method>("method", word,
                        {{name_of(Method::pdg), Method::pdg}, {name_of(Method::pdt), Method::pdt}});
}
Budget budget_of(int steps, double microseconds) {
  if (steps < 0 || !(microseconds >= 0))
    throw std::invalid_argument("a budget must be zero (none) or more");
  return {.steps = steps, .microseconds = microseconds};
}

SharedBody shared(std::shared_ptr<const sonde::Body> body) {
  BodyFacts known = sonde::facts(*body);
  return {std::move(body), std::move(known)};
}

void need_columns(const py::array& array, const char* what) {
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw std::invalid_argument(std::string(what) + " must be of shape (n, 3)");
}

/// Numbers with a fraction are no indices, and are not rounded to some.
Faces faces_in(const py::object& given) {
  const py::array array(given);
  need_columns(array, "faces");
  const char kind = array.dtype().kind();
  if (array.size() > 0 && kind != 'i' && kind != 'u')
    throw std::invalid_argument("faces must be integers: indices of vertices");
  return Faces(array);
}

SharedBody body_of(const Numbers& vertices, const py::object& given_faces, const std::string& model,
                   const std::string& name, const std::string& repair) {
  need_columns(vertices, "vertices");
  const Faces faces = faces_in(given_faces);
  std::vector<Vec3> points(static_cast<std::size_t>(vertices.shape(0)));
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = Eigen::Map<const Vec3>(vertices.data() + 3 * i);
  std::vector<std::array<std::uint32_t, 3>> triangles(static_cast<std::size_t>(faces.shape(0)));
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const std::int64_t corner = faces.data()[3 * i + j];
      if (corner < 0 || static_cast<std::size_t>(corner) >= points.size())
        throw InputError::in(name, "face " + std::to_string(i) + ": there is no vertex " +
                                       std::to_string(corner) + ", only " +
                                       std::to_string(points.size()));
      triangles[i][j] = static_cast<std::uint32_t>(corner);
    }
  const Model chosen_model = model_of(model);
  const Repair chosen_repair = repair_of(repair);
  const py::gil_scoped_release released;
  return shared(make_body(points, triangles, chosen_model, name, chosen_repair));
}

SharedBody body_in(const std::filesystem::path& file, const std::string& model, double scale,
                   const std::string& repair) {
  const Model chosen_model = model_of(model);
  const Repair chosen_repair = repair_of(repair);
  const py::gil_scoped_release released;
  return shared(read_body(file, chosen_model, scale, {}, chosen_repair));
}

SharedBody offset_of(const SharedBody& body, double by) {
  const py::gil_scoped_release released;
  return shared(offset_body(*body.body, by));
}

Depths depth(const SharedBody& a, const SharedBody& b, const Numbers& poses,
             const std::string& method, std::uint64_t seed, unsigned threads, int budget_steps,
             double budget_us, bool whole_bound) {
  const std::vector<Pose> given = poses_of(poses);
  app::SolverOptions options;
  options.method = name_of(method_of(method));
  options.budget = budget_of(budget_steps, budget_us);
  options.seed = seed;
  options.threads = std::min(threads, 1024U);
  if (whole_bound) options.bound = true;
  std::vector<Separation> rows(given.size());
  {
    const py::gil_scoped_release released;
    const Pair pair(a.body, b.body);
    app::ProgressLine quiet(true);
    const auto results = app::search_all(pair, given, options, quiet);
    std::ranges::transform(results, rows.begin(), &app::TimedSeparation::separation);
  }
  return depths_of(rows);
}

/// The coherent solver. A search starts it, at the first pose and after each restart().
class PathFollower {
 public:
  PathFollower(const SharedBody& a, const SharedBody& b, const std::string& method,
               std::uint64_t seed)
      : method_(method_of(method)), seed_(seed), pair_(a.body, b.body), follower_(pair_, method_) {}

  Depths follow(const Numbers& poses, int budget_steps, double budget_us) {
    const std::vector<Pose> given = poses_of(poses);
    const Budget budget = budget_of(budget_steps, budget_us);
    std::vector<Separation> rows;
    rows.reserve(given.size());
    const std::unique_lock<std::mutex> mine = taken();
    {
      const py::gil_scoped_release released;
      for (const Pose& pose : given) rows.push_back(next(pose, budget));
    }
    return depths_of(rows);
  }
  void restart() {
    const std::unique_lock<std::mutex> mine = taken();
    started_ = false;
  }

 private:
  /// Waiting would be with the interpreter's lock, which the one who has it needs.
  std::unique_lock<std::mutex> taken() {
    std::unique_lock<std::mutex> lock(in_use_, std::try_to_lock);
    if (!lock) throw std::runtime_error("another thread uses this follower");
    return lock;
  }
  Separation next(const Pose& pose, const Budget& budget) {
    if (started_) return follower_.follow(pose, budget);
    const Separation& first =
        follower_.start(pose, {.method = method_, .budget = budget, .seed = seed_});
    started_ = first.status != Status::failed;
    return first;
  }
  Method method_;
  std::uint64_t seed_;
  Pair pair_;
  sonde::Follower follower_;
  bool started_ = false;
  std::mutex in_use_;
};

py::array_t<double> three(const Vec3& v) { return py::array_t<double>(3, v.data()); }

void declare_body(py::module_& module) {
  py::class_<SharedBody>(module, "Body", "A rigid body made of triangles. It is immutable.")
      .def(py::init(&body_of), "vertices"_a, "faces"_a, "model"_a = "auto", "name"_a = "body",
           "repair"_a = "auto",
           "Makes a body from vertices (n, 3), metres, and faces (m, 3), indices of vertices,\n"
           "counter-clockwise seen from outside. model: \"solid\" (the inside counts),\n"
           "\"surface\" (the triangles alone) or \"auto\" (solid where it looks closed).\n"
           "repair: \"auto\" (what looks closed is closed; no vertex moves) or \"none\".\n"
           "Raises InputError if they cannot be a body.")
      .def_static(
          "read", &body_in, "file"_a, "model"_a = "auto", "scale"_a = 1.0, "repair"_a = "auto",
          "Reads a mesh file (OFF, OBJ, PLY, STL, GLB, glTF, 3MF, DAE), a str or a path; model as\n"
          "above. scale is its unit in metres; the last four state theirs, and it comes on top.\n"
          "Raises InputError, which names the file and the line.")
      .def("offset", &offset_of, "by"_a,
           "The body with each face moved by that length, metres: inwards where negative (an\n"
           "allowance, with which a peg as large as its hole fits), outwards where positive (a\n"
           "safety). Centre of mass and inertia stay, so that depths can be compared.\n"
           "Raises InputError for a surface, and where the body is thinner than twice as much.")
      .def_property_readonly(
          "offset_by", [](const SharedBody& b) { return b.facts.offset.by; },
          "By how much its faces are outside of those of its mesh, m.")
      .def_property_readonly(
          "name", [](const SharedBody& b) { return b.facts.name; }, "Its file, or the given name.")
      .def_property_readonly(
          "triangles", [](const SharedBody& b) { return b.facts.triangles; },
          "Number of triangles that have an area.")
      .def_property_readonly(
          "solid", [](const SharedBody& b) { return b.facts.solid; }, "Whether its inside counts.")
      .def_property_readonly(
          "why", [](const SharedBody& b) { return b.facts.why; }, "Why it is a solid or a surface.")
      .def_property_readonly(
          "mended", [](const SharedBody& b) { return b.facts.mended; },
          "What was done so that it has an inside, a sentence each.")
      .def_property_readonly(
          "measure", [](const SharedBody& b) { return b.facts.mass.measure; },
          "Volume of a solid, m^3; area of a surface, m^2.")
      .def_property_readonly(
          "centre_of_mass", [](const SharedBody& b) { return three(b.facts.mass.com); },
          "Centre of mass in the mesh frame, m, shape (3,).")
      .def_property_readonly(
          "inertia", [](const SharedBody& b) { return three(b.facts.mass.inertia); },
          "Principal moments of inertia divided by the measure, m^2, ascending, shape (3,).");
}

void declare_depths(py::module_& module) {
  py::class_<Depths>(module, "Depths", "Results as arrays, one row for each pose.")
      .def_readonly("status", &Depths::status, "\"separated\", \"penetrating\" or \"failed\".")
      .def_readonly("reason", &Depths::reason, "Why a pose failed; empty where it did not.")
      .def_readonly("depth", &Depths::depth, "sqrt(PD_g), m; NaN where the pose failed.")
      .def_readonly("sigma", &Depths::sigma, "The square of the depth, m^2.")
      .def_readonly("pose", &Depths::pose, "The separated pose, (n, 7): px,py,pz,qw,qx,qy,qz.")
      .def_readonly("lower_bound", &Depths::lower_bound,
                    "Lower bound of the depth, m; NaN where there is none.")
      .def_readonly("contacts", &Depths::contacts,
                    "Number of contact clusters that carry the separation.")
      .def_readonly("residual", &Depths::residual,
                    "|y - J^T lambda| / |y|: distance from a local optimum.")
      .def_readonly("iterations", &Depths::iterations, "Steps of the local optimiser.")
      .def_readonly("converged", &Depths::converged, "False where the budget ran out first.")
      .def_readonly("jumped", &Depths::jumped,
                    "The force is not continuous here: a search found the separated pose,\n"
                    "or the path led over an edge.")
      .def("__len__", [](const Depths& d) { return d.reason.size(); });
}

void declare_follower(py::module_& module) {
  py::class_<PathFollower>(
      module, "Follower",
      "Follows a moving probe, pose by pose along free paths, so the separated\n"
      "pose never pops through. Use it from one thread at a time: a second one is refused\n"
      "with RuntimeError.")
      .def(py::init<const SharedBody&, const SharedBody&, const std::string&, std::uint64_t>(),
           "probe"_a, "fixed"_a, "method"_a = "pdg", "seed"_a = 1,
           "Of two bodies that overlap or not. method: \"pdg\" (rigid motions) or \"pdt\"\n"
           "(translations alone); seed: of the search that finds the first separated pose.")
      .def("follow", &PathFollower::follow, "poses"_a, "budget_steps"_a = 0, "budget_us"_a = 0.0,
           "Follows to the next poses, (7,) or (n, 7). A search finds the first separated pose.")
      .def("restart", &PathFollower::restart,
           "Starts again: a search finds the next separated pose.");
}

}  // namespace
}  // namespace sonde::python

PYBIND11_MODULE(_sonde, module) {
  using namespace sonde::python;
  module.doc() = "Penetration depth of two polygon soups.";
  module.attr("__version__") = SONDE_VERSION;
  py::register_exception<sonde::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Why the input cannot be a body or cannot be read; names the file and the line.";
  declare_body(module);
  declare_depths(module);
  declare_follower(module);
  module.def("depth", &depth, "probe"_a, "fixed"_a, "poses"_a, py::kw_only(), "method"_a = "pdg",
             "seed"_a = 1, "threads"_a = 0, "budget_steps"_a = 0, "budget_us"_a = 0.0,
             "whole_bound"_a = false,
             "The penetration depth of the probe at each of the poses, (7,) or (n, 7):\n"
             "px,py,pz,qw,qx,qy,qz, the probe's mesh frame in the fixed body's, metres.\n"
             "Searches each pose by itself, on `threads` threads (0: all of the machine's).\n"
             "The number of threads does not change the results. They are the same bits as\n"
             "those of `sonde query`, and with `whole_bound` those of `sonde query --bound`:\n"
             "a lower bound that may take longer than the search.");
}
