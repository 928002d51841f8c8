// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bodies.hpp"

#include <iostream>
#include <utility>

#include "app/options.hpp"
#include "engine/mending/repair_sentences.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/settings/settings.hpp"
#include "engine/text/counted.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

void add_models(CLI::App& parser, BodyOptions& options) {
  const auto models = CLI::IsMember({"auto", "solid", "surface"});
  const std::string doc =
      ": solid (the interior counts), surface (only the triangles) or auto (solid where it "
      "looks closed)";
  parser.add_option("--probe-model", options.probe_model, "the probe's model" + doc)->check(models);
  parser.add_option("--fixed-model", options.fixed_model, "the fixed body's model" + doc)
      ->check(models);
  add_repair(parser, options.repair);
}

/// The remarks on a body as one; empty where there are none.
std::string remark_on(const char* which, const Body& body) {
  std::string all;
  for (const std::string& remark : remarks_on(body)) all += (all.empty() ? "" : "; ") + remark;
  return all.empty() ? all : which + (" " + printable(body.name)) + ": " + all;
}

}  // namespace

void add_scene(CLI::App& parser, BodyOptions& options) {
  parser.add_option("SCENE", options.scene, "scene file, NAME.sonde.json")->required();
  add_within(parser, options.within);
  add_models(parser, options);
  add_offsets(parser, "the probe", options.allowance, options.safety);
}

void add_scene_or_meshes(CLI::App& parser, BodyOptions& options) {
  CLI::Option* scene = parser.add_option("SCENE", options.scene, "scene file, NAME.sonde.json");
  CLI::Option* probe = parser.add_option("--probe", options.probe, "mesh of the moving body");
  CLI::Option* fixed = parser.add_option("--fixed", options.fixed, "mesh of the body that stays");
  probe->excludes(scene)->needs(fixed);
  fixed->excludes(scene)->needs(probe);
  add_within(parser, options.within);
  add_models(parser, options);
  add_offsets(parser, "the probe", options.allowance, options.safety);
  parser.add_option("--probe-scale", options.probe_scale, "factor for the probe's coordinates")
      ->needs(probe)
      ->check(check_positive)
      ->capture_default_str();
  parser
      .add_option("--fixed-scale", options.fixed_scale, "factor for the fixed body's coordinates")
      ->needs(fixed)
      ->check(check_positive)
      ->capture_default_str();
  parser.add_option("--unit", options.unit, "unit of the two meshes")
      ->needs(probe)
      ->check(CLI::IsMember(file_unit_names()))
      ->capture_default_str();
}

void add_repair(CLI::App& parser, std::string& repair) {
  parser
      .add_option("--repair", repair,
                  "what is done to a mesh that is not closed: auto (cracks closed by name, parts "
                  "turned, small openings capped; nothing moves) or none (as in the file)")
      ->check(CLI::IsMember({"auto", "none"}));
}

std::vector<std::string> remarks_on(const Body& body) {
  std::vector<std::string> remarks = body.remarks;
  if (body.degenerate > 0)
    remarks.push_back(counted(body.degenerate, "triangle") + " without area set aside");
  for (std::string& sentence : sentences(body.repairs)) remarks.push_back(std::move(sentence));
  if (body.repairs.could_be_solid)
    remarks.push_back((body.solid ? "" : "taken as a surface: ") + body.why);
  return remarks;
}

void say_remarks_on(const Body& body, const std::string& name) {
  for (const std::string& remark : remarks_on(body))
    std::cerr << "sonde: " << printable(name) << ": " << remark << '\n';
}

std::vector<std::string> remarks_on(const Pair& pair) {
  std::vector<std::string> remarks{remark_on("the probe", pair.probe()),
                                   remark_on("the fixed body", pair.fixed())};
  if (const std::string& mass = pair.probe().mass_why; !mass.empty())
    remarks.push_back("the probe has its mass " + mass);
  if (const std::string words = offset_words(pair.probe().offset); !words.empty())
    remarks.push_back("the probe is " + words);
  std::erase(remarks, "");
  return remarks;
}

Scene scene_of(const BodyOptions& options) {
  Scene scene;
  if (!options.scene.empty()) {
    scene = scene_at(options.scene, options.within);
  } else if (!options.probe.empty()) {
    scene.unit = unit_in_metres(options.unit).value();
    scene.probe.mesh = options.probe;
    scene.probe.scale = options.probe_scale;
    scene.fixed.mesh = options.fixed;
    scene.fixed.scale = options.fixed_scale;
  } else {
    throw UsageError("give a SCENE, or --probe and --fixed");
  }
  if (!options.probe_model.empty()) scene.probe.model = model_named(options.probe_model).value();
  if (!options.fixed_model.empty()) scene.fixed.model = model_named(options.fixed_model).value();
  if (!options.repair.empty())
    scene.probe.repair = scene.fixed.repair = repair_named(options.repair).value();
  scene.probe.offset = offset_of(options.allowance, options.safety).value_or(scene.probe.offset);
  return scene;
}

void add_offsets(CLI::App& parser, const std::string& whose, std::optional<double>& allowance,
                 std::optional<double>& safety) {
  CLI::Option* smaller =
      parser
          .add_option("--allowance", allowance,
                      "takes " + whose + " smaller: each face inwards by this length, m")
          ->check(check_not_negative);
  parser
      .add_option("--safety", safety,
                  "takes " + whose + " larger: each face outwards by this length, m")
      ->check(check_not_negative)
      ->excludes(smaller);
}

std::optional<double> offset_of(const std::optional<double>& allowance,
                                const std::optional<double>& safety) {
  if (allowance) return -*allowance;
  return safety;
}

void add_within(CLI::App& parser, std::string& folder) {
  parser
      .add_option(
          "--paths-within", folder,
          "refuse a scene or recording whose paths lead out of this folder, for those of strangers")
      ->check(CLI::ExistingDirectory);
}

Scene scene_at(const std::string& file, const std::string& within) {
  Scene scene = within.empty() ? read_scene(file) : read_scene_within(within, file);
  require_meshes(scene);
  return scene;
}

void take_trajectory(Scene& scene, const std::string& given) {
  if (given.empty()) return;
  scene.trajectory = given;
  scene.trajectory_line = 0;
}

std::vector<std::filesystem::path> inputs_of(const Scene& scene) {
  std::vector<std::filesystem::path> files{scene.file};
  for (const SceneBody* whole : {&scene.probe, &scene.fixed})
    for (const SceneBody& body : meshes_of(*whole)) files.push_back(body.mesh);
  return files;
}

Pair load_bodies(const Scene& scene, bool quiet, ProgressLine& progress) {
  auto probe = load(scene.probe, scene.unit, progress.percent("reading the probe"));
  auto fixed = load(scene.fixed, scene.unit, progress.percent("reading the fixed body"));
  const Pair pair(std::move(probe), std::move(fixed));
  progress.clear();
  if (!quiet)
    for (const std::string& remark : remarks_on(pair)) std::cerr << "sonde: " << remark << '\n';
  return pair;
}

Pair load_bodies(const Scene& scene, bool quiet) {
  ProgressLine progress(quiet);
  return load_bodies(scene, quiet, progress);
}

}  // namespace sonde::app
