// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mesh_options.hpp"

#include "app/bodies.hpp"
#include "app/options.hpp"
#include "engine/text/file_unit.hpp"

namespace sonde::app {

void add_flags(CLI::App& parser, MeshOptions& options, const std::string& whose) {
  parser
      .add_option("--model", options.model,
                  "solid (the interior counts), surface (only the triangles) or auto")
      ->check(CLI::IsMember({"auto", "solid", "surface"}))
      ->capture_default_str();
  add_repair(parser, options.repair);
  parser.get_option("--repair")->capture_default_str();
  parser.add_option("--unit", options.unit, "unit of the files")
      ->check(CLI::IsMember(file_unit_names()))
      ->capture_default_str();
  parser
      .add_option("--scale", options.scale, "factor for the coordinates, in addition to the unit")
      ->check(check_positive)
      ->capture_default_str();
  add_offsets(parser, whose, options.allowance, options.safety);
}

std::shared_ptr<const Body> load(const std::string& mesh, const MeshOptions& options,
                                 const Progress& progress) {
  const SceneBody body{.mesh = mesh,
                       .model = model_named(options.model).value(),
                       .repair = repair_named(options.repair).value(),
                       .scale = options.scale,
                       .pose = {},
                       .offset = offset_of(options.allowance, options.safety).value_or(0)};
  return sonde::load(body, unit_in_metres(options.unit).value(), progress);
}

}  // namespace sonde::app
