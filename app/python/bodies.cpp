// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/bodies.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <vector>

#include "app/python/arguments.hpp"
#include "app/python/every_row.hpp"
#include "app/python/interruptible.hpp"
#include "app/python/poses.hpp"
#include "app/python/words.hpp"

namespace sonde::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
using Faces = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

Model model_of(const std::string& word) {
  return chosen<Model>(
      "model", word,
      {{"auto", Model::automatic}, {"solid", Model::solid}, {"surface", Model::surface}});
}

Repair repair_of(const std::string& word) {
  return chosen<Repair>("repair", word, {{"auto", Repair::automatic}, {"none", Repair::none}});
}

SharedBody shared(std::shared_ptr<const sonde::Body> body, py::tuple recipe) {
  BodyFacts known = sonde::facts(*body);
  std::uint64_t mark = 0;
  {
    const py::gil_scoped_release released;
    mark = sonde::fingerprint(*body);
  }
  return {std::move(body), std::move(known), std::move(recipe), mark};
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

/// What was made of the arrays is made of them again elsewhere: as they were, whatever becomes of
/// those that were given.
py::array copied(const py::array& array) { return array.attr("copy")().cast<py::array>(); }

SharedBody body_of(const py::object& given_vertices, const py::object& given_faces,
                   const ModelArgument& model, const NameArgument& name,
                   const RepairArgument& repair, const py::object& progress) {
  const Numbers vertices = numbers_in(given_vertices, "vertices");
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
        throw InputError::in(name.value, "face " + std::to_string(i) + ": there is no vertex " +
                                             std::to_string(corner) + ", only " +
                                             std::to_string(points.size()));
      triangles[i][j] = static_cast<std::uint32_t>(corner);
    }
  const Model chosen_model = model_of(model);
  const Repair chosen_repair = repair_of(repair);
  auto body = interruptible(progress, [&](Interruptible& state) {
    return make_body(points, triangles, chosen_model, name, chosen_repair, state.progress());
  });
  return shared(std::move(body), py::make_tuple("arrays", copied(vertices), copied(faces),
                                                model.value, name.value, repair.value));
}

SharedBody body_in(const FileArgument& given, const ModelArgument& model,
                   const Argument<"scale", double>& scale, const RepairArgument& repair,
                   const py::object& progress) {
  const std::filesystem::path& file = given;
  const Model chosen_model = model_of(model);
  const Repair chosen_repair = repair_of(repair);
  auto body = interruptible(progress, [&](Interruptible& state) {
    return read_body(file, chosen_model, scale, state.progress(), chosen_repair);
  });
  return shared(std::move(body), py::make_tuple("file", std::filesystem::absolute(file).string(),
                                                model.value, scale.value, repair.value));
}

SharedBody mesh_of(const py::object& mesh, const ModelArgument& model, const NameArgument& name,
                   const RepairArgument& repair) {
  if (!py::hasattr(mesh, "vertices") || !py::hasattr(mesh, "faces"))
    throw std::invalid_argument("mesh must have .vertices and .faces");
  return body_of(mesh.attr("vertices"), mesh.attr("faces"), model, name, repair, py::none());
}

SharedBody offset_of(const SharedBody& body, const Argument<"by", double>& by) {
  auto moved = interruptible(py::none(), [&](Interruptible& state) {
    return offset_body(*body.body, by, state.progress());
  });
  return shared(std::move(moved), py::make_tuple("offset", body, by.value));
}

SharedBody with_mass_of(const SharedBody& body, const Argument<"measure", double>& measure,
                        const py::object& centre_of_mass, const py::object& inertia,
                        const py::object& axes) {
  MassProperties mass = body.facts.mass;
  if (measure.value > 0) mass.measure = measure;
  if (measure.value < 0) throw std::invalid_argument("measure must not be negative");
  const auto one = [](const py::object& given, const char* what) {
    const Points points = points_of(given, what);
    if (!points.one) throw std::invalid_argument(std::string(what) + " must be of shape (3,)");
    return points.rows[0];
  };
  if (!centre_of_mass.is_none()) mass.com = one(centre_of_mass, "centre_of_mass");
  if (!inertia.is_none()) mass.inertia = one(inertia, "inertia");
  if (!axes.is_none()) {
    const Points rows = points_of(axes, "axes");
    if (rows.one || rows.rows.size() != 3)
      throw std::invalid_argument("axes must be of shape (3, 3), a principal axis in each column");
    for (int i = 0; i < 3; ++i) mass.R_MP.row(i) = rows.rows[static_cast<std::size_t>(i)];
  }
  return shared(with_mass(*body.body, mass),
                py::make_tuple("mass", body, measure.value, centre_of_mass, inertia, axes));
}

/// Makes a body again as it was made. A file must still hold what it did.
SharedBody made_again(const py::tuple& state) {
  const auto recipe = state[0].cast<py::tuple>();
  const auto how = recipe[0].cast<std::string>();
  const auto text = [&](std::size_t i) { return recipe[i].cast<std::string>(); };
  const auto number = [&](std::size_t i) { return recipe[i].cast<double>(); };
  SharedBody out = how == "arrays" ? body_of({recipe[1].cast<Numbers>()}, recipe[2], {text(3)},
                                             {text(4)}, {text(5)}, py::none())
                   : how == "file"
                       ? body_in({text(1)}, {text(2)}, {number(3)}, {text(4)}, py::none())
                   : how == "offset" ? offset_of(recipe[1].cast<const SharedBody&>(), {number(2)})
                                     : with_mass_of(recipe[1].cast<const SharedBody&>(),
                                                    {number(2)}, recipe[3], recipe[4], recipe[5]);
  if (out.facts.triangles != state[1].cast<std::size_t>() ||
      out.facts.mass.measure != state[2].cast<double>())
    throw InputError::in(out.facts.name, "is not what it was when the body was pickled");
  return out;
}

py::array_t<double> three(const Vec3& v) { return py::array_t<double>(3, v.data()); }

py::array_t<double> vertices_of(const SharedBody& body) {
  const std::span<const Vec3> all = vertices(*body.body);
  return rows_of(all.size(), 3, [&](std::size_t i, std::size_t j) {
    return all[i][static_cast<Eigen::Index>(j)];
  });
}

py::array_t<std::int64_t> faces_of(const SharedBody& body) {
  const auto all = triangles(*body.body);
  py::array_t<std::int64_t> out({static_cast<py::ssize_t>(all.size()), py::ssize_t{3}});
  std::int64_t* to = out.mutable_data();
  for (const auto& triangle : all)
    for (const std::uint32_t corner : triangle) *to++ = corner;
  return out;
}

/// Of points: an array of answers, or one for a single point.
py::object inside_of(const SharedBody& body, const py::object& given) {
  const Points points = points_of(given, "points");
  if (points.one) return py::bool_(inside(*body.body, points.rows[0]));
  py::array_t<bool> out(static_cast<py::ssize_t>(points.rows.size()));
  for_every_row(points.rows.size(), Takes::microseconds, [&, to = out.mutable_data()](auto i) {
    to[i] = inside(*body.body, points.rows[i]);
  });
  return out;
}

py::object part_names(const SharedBody& body, const py::object& given) {
  const Points points = points_of(given, "points");
  std::vector<std::string> names(points.rows.size());
  for_every_row(names.size(), Takes::microseconds,
                [&](auto i) { names[i] = part_at(*body.body, points.rows[i]); });
  return points.one ? py::cast(names[0]) : py::cast(names);
}

/// Point, normal and distance of each, as arrays; what is not there is not a number.
py::tuple surface_points(const std::vector<std::optional<SurfacePoint>>& rows, bool one) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto vectors = [&](const Vec3 SurfacePoint::*member) {
    return rows_of(rows.size(), 3, [&](std::size_t i, std::size_t j) {
      return rows[i] ? ((*rows[i]).*member)[static_cast<Eigen::Index>(j)] : none;
    });
  };
  py::object point = vectors(&SurfacePoint::point), normal = vectors(&SurfacePoint::normal);
  py::object distance = rows_of(rows.size(), 1, [&](std::size_t i, std::size_t) {
    return rows[i] ? rows[i]->distance : none;
  });
  if (!one) return py::make_tuple(point, normal, distance);
  return py::make_tuple(point[py::int_(0)], normal[py::int_(0)], distance[py::int_(0)]);
}

py::tuple nearest_of(const SharedBody& body, const py::object& given) {
  const Points points = points_of(given, "points");
  std::vector<std::optional<SurfacePoint>> rows(points.rows.size());
  for_every_row(rows.size(), Takes::microseconds,
                [&](auto i) { rows[i] = nearest_point(*body.body, points.rows[i]); });
  return surface_points(rows, points.one);
}

py::tuple ray_of(const SharedBody& body, const py::object& origins, const py::object& directions) {
  const Points from = points_of(origins, "origins"), along = points_of(directions, "directions");
  if (from.rows.size() != along.rows.size())
    throw std::invalid_argument("origins and directions must be as many");
  std::vector<std::optional<SurfacePoint>> rows(from.rows.size());
  for_every_row(rows.size(), Takes::microseconds,
                [&](auto i) { rows[i] = ray(*body.body, from.rows[i], along.rows[i]); });
  return surface_points(rows, from.one && along.one);
}

}  // namespace

void declare_body(py::module_& module) {
  py::class_<SharedBody>(module, "Body", "A rigid body made of triangles. It is immutable.")
      .def(py::init(&body_of), "vertices"_a, "faces"_a, "model"_a = "auto", "name"_a = "body",
           "repair"_a = "auto", "progress"_a = py::none(),
           "Makes a body from vertices (n, 3), metres, and faces (m, 3), indices of vertices,\n"
           "counter-clockwise seen from outside. model: \"solid\" (the inside counts),\n"
           "\"surface\" (the triangles alone) or \"auto\" (solid where it looks closed).\n"
           "repair: \"auto\" (what looks closed is closed; no vertex moves) or \"none\".\n"
           "progress: called with the fraction done; where it returns False, Cancelled is raised.\n"
           "Raises InputError if they cannot be a body.")
      .def_static(
          "read", &body_in, "file"_a, "model"_a = "auto", "scale"_a = 1.0, "repair"_a = "auto",
          "progress"_a = py::none(),
          "Reads a mesh file (OFF, OBJ, PLY, STL, GLB, glTF, 3MF, DAE), a str or a path; model as\n"
          "above. scale is its unit in metres; the last four state theirs, and it comes on top.\n"
          "Raises InputError, which names the file and the line.")
      .def("offset", &offset_of, "by"_a,
           "The body with each face moved by that length, metres: inwards where negative (an\n"
           "allowance, with which a peg as large as its hole fits), outwards where positive (a\n"
           "safety). Centre of mass and inertia stay, so that depths can be compared.\n"
           "Raises InputError for a surface, and where the body is thinner than twice as much.")
      .def_static("from_mesh", &mesh_of, "mesh"_a, "model"_a = "auto", "name"_a = "body",
                  "repair"_a = "auto",
                  "Of an object with .vertices and .faces, such as a trimesh.Trimesh.")
      .def("with_mass", &with_mass_of, py::kw_only(), "measure"_a = 0.0,
           "centre_of_mass"_a = py::none(), "inertia"_a = py::none(), "axes"_a = py::none(),
           "The body with other mass properties, by which motions are measured: measure (any\n"
           "density), centre_of_mass (3,), inertia (3,), the principal moments divided by the\n"
           "measure, m^2, about axes (3, 3), a column each in the mesh frame. What is left out\n"
           "stays. Four times the inertia doubles what a turn costs beside a displacement.")
      .def("inside", &inside_of, "points"_a,
           "Whether points (3,) or (n, 3), in the mesh frame, m, are inside: bool or array.")
      .def("nearest_point", &nearest_of, "points"_a,
           "The nearest point of the surface to each of the points, (3,) or (n, 3), in the mesh\n"
           "frame: point (n, 3), outward normal (n, 3) and distance (n,), m.")
      .def("part_at", &part_names, "points"_a,
           "The name of the part that is nearest to each of the points, (3,) or (n, 3), such as\n"
           "those of contacts: str or list. It is the body's own where that has no parts.")
      .def("ray", &ray_of, "origins"_a, "directions"_a,
           "Where rays, (3,) or (n, 3) each, first meet the surface, from either side: point,\n"
           "normal and distance, NaN where they meet nothing.")
      .def_property_readonly("vertices", &vertices_of,
                             "The vertices after repairs, (n, 3), m, in the mesh frame.")
      .def_property_readonly("faces", &faces_of,
                             "The triangles after repairs, (m, 3), indices of vertices.")
      .def("__repr__",
           [](const SharedBody& b) {
             return "<sonde.Body '" + b.facts.name + "', " + std::to_string(b.facts.triangles) +
                    " triangles, " + (b.facts.solid ? "solid" : "surface") + ">";
           })
      .def(py::pickle(
          [](const SharedBody& b) {
            return py::make_tuple(b.recipe, b.facts.triangles, b.facts.mass.measure);
          },
          &made_again))
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
          "mass_why", [](const SharedBody& b) { return b.facts.mass_why; },
          "By what its mass is, and why, where it has open parts beside closed ones; else empty.")
      .def_property_readonly(
          "mended",
          [](const SharedBody& b) {
            return std::vector(b.facts.mended.begin(), b.facts.mended.end());
          },
          "What was done so that it has an inside, a sentence each.")
      .def_property_readonly(
          "measure", [](const SharedBody& b) { return b.facts.mass.measure; },
          "Volume, m^3, where by_volume; else area, m^2.")
      .def_property_readonly(
          "by_volume", [](const SharedBody& b) { return b.facts.mass.by_volume; },
          "Whether its mass is by volume: that of a surface is by area, and that of a solid of\n"
          "which more than 1 % of the area belongs to open parts.")
      .def_property_readonly(
          "centre_of_mass", [](const SharedBody& b) { return three(b.facts.mass.com); },
          "Centre of mass in the mesh frame, m, shape (3,).")
      .def_property_readonly(
          "inertia", [](const SharedBody& b) { return three(b.facts.mass.inertia); },
          "Principal moments of inertia divided by the measure, m^2, ascending, shape (3,).");
}

}  // namespace sonde::python
