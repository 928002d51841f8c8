// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recordings.hpp"

#include <nlohmann/json.hpp>

#include "engine/base/error.hpp"
#include "engine/text/number_text.hpp"
#include "engine/text/printable.hpp"

namespace sonde::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int shown_digits = 6;

/// Empty where both are as recorded.
std::string wrong_meshes(const Recording& recording) {
  try {
    check_meshes(recording.header, recording.file);
    return {};
  } catch (const InputError& bad) {
    return bad.what();
  }
}

std::uint64_t ticks_in(const Recording& r) { return r.ticks.end() - r.ticks.begin(); }
double duration(const Recording& r) { return r.ticks.last_time() - r.ticks.first_time(); }

std::string text_of(const Recording& r) {
  std::string text = printable(r.file.string()) + '\n';
  const auto line = [&](std::string name, const std::string& value) {
    constexpr std::size_t letters = 16;
    name.resize(letters, ' ');
    text.append("  ").append(name).append(printable(value)).append("\n");
  };
  const Scene& scene = r.header.scene;
  line("recording of", scene.name);
  line("begun", r.header.started);
  line("duration", number_text(duration(r), shown_digits) + " s");
  line("ticks", std::to_string(ticks_in(r)));
  line("rate asked", number_text(r.header.rate_hz, shown_digits) + " Hz");
  line("searches", std::to_string(r.ticks.searches().size()));
  line("probe", scene.probe.mesh.string());
  line("fixed body", scene.fixed.mesh.string());
  const std::string meshes = wrong_meshes(r);
  line("meshes", meshes.empty() ? "as recorded" : meshes);
  line("size", std::to_string(r.bytes) + " bytes");
  line("ends", r.cut.empty() ? "whole" : "cut: " + r.cut);
  return text;
}

Json json_of(const Recording& r) {
  const Scene& scene = r.header.scene;
  Json json{{"file", utf8_text(r.file.string())},
            {"name", utf8_text(scene.name)},
            {"started", r.header.started},
            {"duration", duration(r)},
            {"ticks", ticks_in(r)},
            {"rate", r.header.rate_hz},
            {"searches", r.ticks.searches().size()},
            {"probe", utf8_text(scene.probe.mesh.string())},
            {"fixed", utf8_text(scene.fixed.mesh.string())},
            {"bytes", r.bytes},
            {"readable_bytes", r.readable},
            {"whole", r.cut.empty()}};
  if (!r.cut.empty()) json["cut"] = r.cut;
  const std::string meshes = wrong_meshes(r);
  json["meshes_as_recorded"] = meshes.empty();
  if (!meshes.empty()) json["meshes"] = utf8_text(meshes);
  return json;
}

}  // namespace

std::unique_ptr<Recording> recording_at(const std::filesystem::path& file,
                                        const std::string& within, const Progress& progress) {
  if (!within.empty())
    for (const std::filesystem::path& path : recorded_paths_out_of(within, file))
      throw InputError::in(file.string(),
                           "its scene names " + path.string() + ", out of the folder " + within);
  return read_recording(file, progress);
}

std::string to_text(const std::vector<std::unique_ptr<Recording>>& recordings) {
  std::string text;
  for (const auto& recording : recordings)
    text.append(text.empty() ? "" : "\n").append(text_of(*recording));
  return text;
}

std::string to_json(const std::vector<std::unique_ptr<Recording>>& recordings) {
  Json json;
  json["format"] = 1;
  json["units"] = {{"duration", "s"}, {"rate", "Hz"}};
  json["recordings"] = Json::array();
  for (const auto& recording : recordings) json["recordings"].push_back(json_of(*recording));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace sonde::app
