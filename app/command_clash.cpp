// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <deque>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <tuple>
#include <utility>
#include <vector>

#include "app/bodies.hpp"
#include "app/commands.hpp"
#include "app/result_table.hpp"
#include "engine/offset/offset_faces.hpp"
#include "engine/study/assembly/clash_picture.hpp"
#include "engine/text/file_unit.hpp"
#include "engine/text/output_file.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

struct ClashFlags {
  std::vector<std::string> files;
  std::string model = "auto", repair = "auto", unit = "m", within_folder;
  double scale = 1;
  bool components = false;
  ClashOptions options;
  unsigned threads = 0;
  OutputOptions output;
  std::string pictures;  ///< a folder; empty: none
};

constexpr std::array<Column, 18> clash_columns{{{"a", ""},
                                                {"b", ""},
                                                {"kind", ""},
                                                {"depth", "m"},
                                                {"lower_bound", "m"},
                                                {"clearance", "m"},
                                                {"x", "m"},
                                                {"y", "m"},
                                                {"z", "m"},
                                                {"moved", ""},
                                                {"px", "m"},
                                                {"py", "m"},
                                                {"pz", "m"},
                                                {"qw", ""},
                                                {"qx", ""},
                                                {"qy", ""},
                                                {"qz", ""},
                                                {"reason", ""}}};

bool is_scene(const std::string& file) { return file.ends_with(".json"); }

/// A name of its own for each part.
std::string new_name(std::set<std::string>& names, const std::string& wanted) {
  std::string name = wanted;
  for (int k = 2; !names.insert(name).second; ++k) name = wanted + " (" + std::to_string(k) + ")";
  return name;
}

/// A mesh of its own by its file's name, or by its path as given where another file has that name.
std::string name_beside(const std::vector<std::string>& files, const SceneBody& mesh) {
  const std::filesystem::path& own = mesh.mesh;
  const bool shared = std::ranges::any_of(files, [&](const std::filesystem::path& other) {
    return other.filename() == own.filename() && other != own;
  });
  return shared ? own.string() : std::string();
}

/// A body in the world of its assembly, and the unit of its mesh.
struct Placed {
  SceneBody body;
  double unit;
};

/// The parts of a body, each where it stands in the world.
void add_parts(std::vector<Placed>& out, const SceneBody& whole, double unit,
               ComponentFiles& files) {
  const SceneBody body = with_components(whole, unit, files);
  if (body.parts.empty()) return out.push_back({body, unit});
  for (SceneBody part : body.parts) {
    part.scale *= body.scale;
    part.pose.p *= body.scale;
    part.pose = body.pose * part.pose;
    part.scene_file = body.scene_file;
    part.offset = body.offset;
    out.push_back({part, unit});
  }
}

/// The parts of all scenes, at their poses, and the meshes as they lie in their files.
std::vector<Placed> placed(const ClashFlags& flags, ComponentFiles& files) {
  std::vector<Placed> out;
  for (const std::string& file : flags.files) {
    if (is_scene(file)) {
      const Scene scene = scene_at(file, flags.within_folder);
      for (const SceneBody* body : {&scene.probe, &scene.fixed})
        add_parts(out, *body, scene.unit, files);
      continue;
    }
    SceneBody body;
    body.mesh = file;
    body.model = model_named(flags.model).value();
    body.repair = repair_named(flags.repair).value();
    body.scale = flags.scale;
    body.components = flags.components;
    if (!flags.components) body.name = name_beside(flags.files, body);
    add_parts(out, body, unit_in_metres(flags.unit).value(), files);
  }
  return out;
}

/// Bodies by themselves, in their mesh frames: parts that are alike (a screw, many times) are one.
class Loader {
 public:
  explicit Loader(ComponentFiles& files) : files_(files) {}
  std::shared_ptr<const Body> operator()(const Placed& part) {
    const SceneBody& b = part.body;
    if (b.offset != 0 || !b.parts.empty() || b.components) return load(b, part.unit);
    std::shared_ptr<const Body>& body =
        known_[{b.mesh, b.component, b.model, b.repair, b.scale, part.unit}];
    if (!body) body = read(part);
    return body;
  }

 private:
  using Key = std::tuple<std::filesystem::path, std::size_t, Model, Repair, double, double>;
  std::shared_ptr<const Body> read(const Placed& part) {
    if (part.body.component == 0) return load(part.body, part.unit);
    SceneBody whole;
    whole.scene_file = part.body.scene_file;
    whole.parts = {part.body};
    return load_part(whole, 0, part.unit, files_).body;
  }

  ComponentFiles& files_;
  std::map<Key, std::shared_ptr<const Body>> known_;
};

/// What a reader of the list must know of a part, a scene's allowance among it.
std::vector<std::string> part_remarks(const AssemblyPart& part) {
  std::vector<std::string> remarks = remarks_on(*part.body);
  if (std::string words = offset_words(part.body->offset); !words.empty())
    remarks.push_back(std::move(words));
  for (std::string& remark : remarks) remark.insert(0, part.name + ": ");
  return remarks;
}

/// Says each remark on stderr, unless quiet, and keeps it.
std::vector<AssemblyPart> parts_of(const ClashFlags& flags, std::vector<std::string>& remarks) {
  ComponentFiles files;
  const std::vector<Placed> bodies = placed(flags, files);
  Loader load_body_of(files);
  ProgressLine progress(flags.output.quiet);
  std::vector<AssemblyPart> parts;
  std::set<std::string> names;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const SceneBody& body = bodies[i].body;
    parts.push_back({new_name(names, part_name(body)), load_body_of(bodies[i]), body.pose});
    progress.show("reading parts", i + 1, bodies.size());
    for (std::string& remark : part_remarks(parts.back())) {
      progress.clear();
      if (!flags.output.quiet) std::cerr << "sonde: " << printable(remark) << '\n';
      remarks.push_back(std::move(remark));
    }
  }
  return parts;
}

Row row_of(const Clash& clash, const std::deque<std::string>& names) {
  const auto number = [](const std::optional<double>& value) {
    return value ? Cell(*value) : Cell();
  };
  Row row{names[clash.parts[0]].c_str(), names[clash.parts[1]].c_str(), name_of(clash.kind),
          number(clash.depth),           number(clash.lower_bound),     number(clash.clearance)};
  clash.place ? append(row, *clash.place) : append_nothing(row, 3);
  if (clash.separated) {
    row.push_back(names[clash.moved].c_str());
    append(row, *clash.separated);
  } else {
    append_nothing(row, 8);
  }
  row.push_back(clash.reason);
  return row;
}

void note(const std::vector<Clash>& found, std::size_t parts) {
  const auto count = [&](Clash::Kind kind) {
    return std::ranges::count(found, kind, &Clash::kind);
  };
  const auto overlapping = count(Clash::Kind::overlapping), touching = count(Clash::Kind::touching);
  std::cerr << "sonde: " << parts << " parts: " << overlapping
            << (overlapping == 1 ? " pair overlaps, " : " pairs overlap, ") << touching
            << (touching == 1 ? " touches" : " touch");
  if (const auto fits = std::ranges::count(found, true, &Clash::fit))
    std::cerr << " (" << fits << " of them in a fit: their depth is the way out)";
  if (const auto failed = count(Clash::Kind::failed)) std::cerr << ", " << failed << " failed";
  std::cerr << '\n';
}

/// "001-nut-bolt.svg": in the order of the list; of the names, what every file system takes.
std::string picture_name(std::size_t index, const AssemblyPart& a, const AssemblyPart& b) {
  std::string number = std::to_string(index + 1);
  number.insert(0, number.size() < 3 ? 3 - number.size() : 0, '0');
  std::string name = number + "-" + a.name + "-" + b.name;
  for (char& c : name)
    if (c == '/' || c == '\\' || c == ':' || static_cast<unsigned char>(c) < 0x20) c = '_';
  constexpr std::size_t most_bytes = 200;
  if (name.size() > most_bytes) name = number;
  return name + ".svg";
}

void write_pictures(const std::string& folder, const std::vector<AssemblyPart>& parts,
                    const std::vector<Clash>& found) {
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const AssemblyPart &a = parts[found[i].parts[0]], &b = parts[found[i].parts[1]];
    write_whole(std::filesystem::path(folder) / picture_name(i, a, b),
                clash_picture(a, b, found[i]));
  }
}

/// Nothing of others is among the pictures, and an error comes before the work.
void check_picture_folder(const std::string& folder) {
  std::error_code error;
  const bool there = std::filesystem::exists(folder, error);
  if (there && !std::filesystem::is_directory(folder, error))
    throw InputError::in(folder, "is no folder: --pictures needs one");
  if (there && !std::filesystem::is_empty(folder, error))
    throw InputError::in(folder, "is not empty: --pictures needs a new folder, or an empty one");
}

void run(const ClashFlags& flags) {
  check_output(flags.output, {flags.files.begin(), flags.files.end()});
  if (!flags.pictures.empty()) check_picture_folder(flags.pictures);
  ResultTable table{{clash_columns}, {}};
  const std::vector<AssemblyPart> parts = parts_of(flags, table.head.remarks);
  if (parts.size() < 2) throw UsageError("give at least two parts: a scene, or two meshes");
  ClashOptions options = flags.options;
  options.threads =
      flags.threads == 0 ? std::max(1u, std::thread::hardware_concurrency()) : flags.threads;
  ProgressLine progress(flags.output.quiet);
  const std::vector<Clash> found = clashes(parts, options, progress.percent("pairs of parts"));
  progress.clear();
  std::deque<std::string> names;
  for (const AssemblyPart& part : parts) names.push_back(part.name);
  for (const Clash& clash : found) table.rows.push_back(row_of(clash, names));
  write_result(flags.output, flags.output.json ? to_json(table) : to_csv(table));
  if (!flags.pictures.empty()) write_pictures(flags.pictures, parts, found);
  if (!flags.output.quiet) note(found, parts.size());
}

}  // namespace

Command add_clash_command(CLI::App& program) {
  const auto flags = std::make_shared<ClashFlags>();
  CLI::App* parser = program.add_subcommand(
      "clash", "Finds which parts of an assembly overlap, touch or are near, and the way out");
  parser
      ->add_option("PART", flags->files,
                   "scenes (NAME.sonde.json), whose bodies stand at their poses, and meshes, which "
                   "stand as they lie in their files")
      ->required();
  parser
      ->add_option("--within", flags->options.within,
                   "also list pairs that are clear by at most this, m")
      ->check(check_not_negative)
      ->capture_default_str();
  parser
      ->add_option(
          "--allowance", flags->options.allowance,
          "overlaps that are nowhere deeper than this count as touching, and so do gaps, m")
      ->check(check_not_negative)
      ->capture_default_str();
  parser
      ->add_option("--model", flags->model,
                   "of meshes: solid (the interior counts), surface (only the triangles) or auto")
      ->check(CLI::IsMember({"auto", "solid", "surface"}))
      ->capture_default_str();
  add_repair(*parser, flags->repair);
  parser->get_option("--repair")->capture_default_str();
  parser->add_option("--unit", flags->unit, "unit of the mesh files")
      ->check(CLI::IsMember(file_unit_names()))
      ->capture_default_str();
  parser
      ->add_option("--scale", flags->scale, "factor for their coordinates, in addition to the unit")
      ->check(check_positive)
      ->capture_default_str();
  parser->add_flag(
      "--components", flags->components,
      "take each mesh apart: what hangs together is a part, named FILE:1, FILE:2, ...");
  parser->add_option("--pictures", flags->pictures,
                     "a new folder for a picture (SVG) of each pair in the list: a section "
                     "through both, with the way out");
  add_within(*parser, flags->within_folder);
  parser->add_option("--seed", flags->options.search.seed, "seed of the searches' random starts")
      ->check(check_whole)
      ->capture_default_str();
  parser->add_option("--threads", flags->threads, "threads to compute on; 0: all of the machine's")
      ->check(check_whole)
      ->check(CLI::Range(0U, most_threads))
      ->capture_default_str();
  add_flags(*parser, flags->output);
  return {parser, [flags] { run(*flags); }};
}

}  // namespace sonde::app
