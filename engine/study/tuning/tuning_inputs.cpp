// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/tuning/tuning_inputs.hpp"

#include <nlohmann/json.hpp>

#include "engine/study/parts/study_parts.hpp"
#include "engine/text/text_file.hpp"

namespace sonde {
namespace {

using Json = nlohmann::ordered_json;

/// The file's name, not its path, since a shard may run elsewhere.
Json about(const std::filesystem::path& file) {
  constexpr std::size_t most_bytes = std::size_t{4} << 30;
  return {{"file", file.filename().string()},
          {"fingerprint", fingerprint(read_text(file, most_bytes))}};
}

}  // namespace

std::string tuning_inputs(const std::string& version, const TuningFiles& files, const Body& probe,
                          const Body& fixed) {
  Json out{{"version", version},
           {"probe", about(files.probe)},
           {"fixed", about(files.fixed)},
           {"probe_solid", probe.solid},
           {"fixed_solid", fixed.solid},
           {"probe_radius", probe.mass.radius},
           {"fixed_radius", fixed.mass.radius}};
  // For several parts, the file is only that of the first.
  for (const BodyPart& part : fixed.parts)
    out["fixed_parts"].push_back(
        {part.name, part.body->mass.measure, part.X_BP.p.x(), part.X_BP.p.y(), part.X_BP.p.z()});
  if (!files.trajectory.empty()) out["trajectory"] = about(files.trajectory);
  return out.dump();
}

}  // namespace sonde
