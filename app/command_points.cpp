// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/mesh_options.hpp"
#include "app/result_table.hpp"
#include "engine/platform/read_stream.hpp"
#include "engine/sonde.hpp"
#include "engine/text/csv_rows.hpp"

namespace sonde::app {
namespace {

struct PointsOptions {
  std::string mesh, points, rays;
  MeshOptions reading;
  OutputOptions output;
};

/// A point, or a ray from it, in the mesh frame.
struct Asked {
  Vec3 from, direction;
};
struct Found {
  bool inside = false;
  std::optional<SurfacePoint> at;  ///< nearest, or first met; none where a ray meets nothing
  std::string_view part;           ///< the body's
};

constexpr std::array<Column, 10> columns_of_points{{{"index", ""},
                                                    {"inside", ""},
                                                    {"distance", "m"},
                                                    {"x", "m"},
                                                    {"y", "m"},
                                                    {"z", "m"},
                                                    {"nx", ""},
                                                    {"ny", ""},
                                                    {"nz", ""},
                                                    {"part", ""}}};
constexpr std::array<Column, 10> columns_of_rays = [] {
  std::array<Column, 10> out = columns_of_points;
  out[1] = {"hit", ""};
  return out;
}();

std::string file_of(const PointsOptions& options) {
  const std::string& file = options.points.empty() ? options.rays : options.points;
  return file == "-" ? standard_input_name : file;
}

std::vector<Asked> read_asked(const PointsOptions& options) {
  constexpr std::array<std::string_view, 6> names{"x", "y", "z", "dx", "dy", "dz"};
  constexpr double furthest = 1e30;  // of a mesh's coordinates, and of nearest_point()
  constexpr std::size_t most_bytes = std::size_t{1} << 30;
  const bool rays = !options.rays.empty();
  std::vector<Asked> asked;
  read_csv_rows(file_of(options), std::span(names).first(rays ? 6 : 3), most_bytes,
                [&](std::span<const double> row) {
                  for (const double x : row)
                    if (std::abs(x) > furthest)
                      throw std::invalid_argument("a number is beyond 1e30");
                  const Vec3 direction = rays ? Vec3(row[3], row[4], row[5]) : Vec3::Zero();
                  if (rays && direction.isZero(0))
                    throw std::invalid_argument("the direction dx,dy,dz is 0,0,0");
                  asked.push_back({Vec3(row[0], row[1], row[2]), direction});
                });
  return asked;
}

Found answer(const Body& body, const Asked& asked, bool is_ray) {
  Found out;
  if (is_ray)
    out.at = ray(body, asked.from, asked.direction);
  else
    out.at = nearest_point(body, asked.from), out.inside = inside(body, asked.from);
  if (out.at) out.part = part_at(body, out.at->point);
  return out;
}

void check(const PointsOptions& options) {
  if (options.points.empty() == options.rays.empty())
    throw UsageError("give --points or --rays, one of them");
  std::vector<std::filesystem::path> inputs{options.mesh};
  inputs.emplace_back(file_of(options));
  check_output(options.output, inputs);
}

void run(const PointsOptions& options) {
  check(options);
  const std::vector<Asked> asked = read_asked(options);
  ProgressLine progress(options.output.quiet);
  const auto body =
      load(options.mesh, options.reading, progress.percent("reading " + options.mesh));
  progress.clear();
  if (!options.output.quiet) say_remarks_on(*body, options.mesh);
  const bool rays = !options.rays.empty();
  std::set<std::string, std::less<>> names;
  ResultTable table{{rays ? columns_of_rays : columns_of_points}, {}};
  table.head.remarks = remarks_on(*body);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Found found = answer(*body, asked[i], rays);
    Row row{static_cast<std::int64_t>(i), rays ? found.at.has_value() : found.inside};
    if (found.at) {
      row.push_back(found.at->distance);
      append(row, found.at->point);
      append(row, found.at->normal);
      row.push_back(names.emplace(found.part).first->c_str());
    } else {
      append_nothing(row, 8);
    }
    table.rows.push_back(std::move(row));
    progress.show(rays ? "following rays" : "asking about points", i + 1, asked.size());
  }
  progress.clear();
  write_result(options.output, options.output.json ? to_json(table) : to_csv(table));
}

}  // namespace

Command add_points_command(CLI::App& program) {
  const auto options = std::make_shared<PointsOptions>();
  CLI::App* parser = program.add_subcommand(
      "points",
      "Says of points whether they are inside a body and what of it is nearest; of rays, "
      "where they meet it");
  parser->add_option("MESH", options->mesh, "mesh file (OFF, OBJ, PLY, STL, GLB, glTF, 3MF, DAE)")
      ->required();
  auto* points = parser->add_option("--points", options->points,
                                    "CSV x,y,z in the mesh frame, metres; -: standard input");
  parser
      ->add_option("--rays", options->rays,
                   "CSV x,y,z,dx,dy,dz: a ray from a point along a direction of any length; -: "
                   "standard input")
      ->excludes(points);
  add_flags(*parser, options->reading, "the body");
  add_flags(*parser, options->output);
  return {parser, [options] { run(*options); }};
}

}  // namespace sonde::app
