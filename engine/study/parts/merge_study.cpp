// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/parts/merge_study.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/base/error.hpp"

namespace sonde {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out;
}

/// Removes what differs from run to run: members named time_us.
void leave_out_times(Json& json) {
  if (json.is_object()) json.erase("time_us");
  for (Json& each : json)
    if (each.is_structured()) leave_out_times(each);
}

bool same_but_for_times(const std::string& a, const std::string& b) {
  if (a == b) return true;
  Json one = Json::parse(a, nullptr, false), other = Json::parse(b, nullptr, false);
  if (one.is_discarded() || other.is_discarded()) return false;
  leave_out_times(one);
  leave_out_times(other);
  return one == other;
}

/// Takes over the results that are not there yet; throws if both have one and they differ.
void take(StudyFolder& into, std::vector<fs::path>& from, const StudyFolder& other,
          const fs::path& folder) {
  for (std::size_t i = 0; i < into.names.size(); ++i) {
    const auto& result = other.results[i];
    if (!result) continue;
    if (into.results[i] && !same_but_for_times(*into.results[i], *result))
      throw InputError::in(folder.string(), "has another result than " + from[i].string() +
                                                " for the part " + into.names[i]);
    if (into.results[i]) continue;
    into.results[i] = result;
    from[i] = folder;
  }
}

}  // namespace

StudyFolder merge_studies(std::span<const fs::path> folders) {
  if (folders.empty()) throw std::invalid_argument("no study to join");
  StudyFolder out = read_study(folders.front());
  std::vector<fs::path> from(out.names.size(), folders.front());
  for (const fs::path& folder : folders.subspan(1)) {
    const StudyFolder other = read_study(folder);
    if (other.kind != out.kind || other.about != out.about || other.names != out.names)
      throw InputError::in(folder.string(), "holds another study than " + folders.front().string());
    take(out, from, other, folder);
  }
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < out.names.size(); ++i)
    if (!out.results[i]) missing.push_back(out.names[i]);
  if (!missing.empty())
    throw InputError::in(
        folders.front().string(),
        (folders.size() > 1 ? "neither here nor in the other folders are the parts "
                            : "is without the parts ") +
            listed(missing));
  return out;
}

void write_study(const fs::path& folder, const StudyFolder& study) {
  Study whole{study.kind, study.about, {}};
  for (std::size_t i = 0; i < study.names.size(); ++i)
    whole.parts.push_back(
        {study.names[i], [&, i](const Stop&) { return study.results[i].value(); }});
  compute_parts(folder, whole, {}, 1, [] { return false; });
}

}  // namespace sonde
