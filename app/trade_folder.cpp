// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/trade_folder.hpp"

#include <algorithm>
#include <set>
#include <system_error>

#include "engine/base/error.hpp"
#include "engine/study/parts/study_parts.hpp"
#include "engine/study/trade/trade_front.hpp"
#include "engine/text/output_file.hpp"

namespace sonde::app {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view ending = ".sonde.json";

std::vector<std::string> studies_in(const fs::path& folder) {
  std::vector<std::string> out;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (fs::exists(entry.path() / "study.json", none))
      out.push_back(entry.path().filename().string());
  std::ranges::sort(out);
  return out;
}

}  // namespace

std::vector<fs::path> scenes_in(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().ends_with(ending)) out.push_back(entry.path());
  if (out.empty())
    throw InputError::in(folder.string(), "holds no scene, NAME" + std::string(ending));
  std::ranges::sort(out);
  return out;
}

std::string folder_name(const fs::path& scene) {
  const std::string name = scene.filename().string();
  return name.substr(0, name.size() - ending.size());
}

bool write_front(const fs::path& out, const std::vector<std::string>& names) {
  std::vector<TradeResults> pairs;
  for (const std::string& name : names) {
    const std::string folder = (out / name).string();
    const StudyFolder study = read_study(folder);
    if (!study.complete()) return false;
    pairs.push_back(read_trade(folder, study));
  }
  for (const StudyFile& file : front_files(pairs)) write_whole(out / file.name, file.text);
  return true;
}

bool holds_studies(const fs::path& folder) {
  std::error_code none;
  return !fs::exists(folder / "study.json", none) && !studies_in(folder).empty();
}

void merge_fronts(
    const std::vector<std::string>& folders, const fs::path& out,
    const std::function<void(const std::vector<std::string>&, const std::string&)>& merge) {
  std::set<std::string> names;
  for (const std::string& folder : folders)
    for (std::string& name : studies_in(folder)) names.insert(std::move(name));
  for (const std::string& name : names) {
    std::vector<std::string> parts;
    std::error_code none;
    for (const std::string& folder : folders)
      if (fs::exists(fs::path(folder) / name / "study.json", none))
        parts.push_back((fs::path(folder) / name).string());
    merge(parts, (out / name).string());
  }
  write_front(out, {names.begin(), names.end()});
}

}  // namespace sonde::app
