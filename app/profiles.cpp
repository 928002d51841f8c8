// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profiles.hpp"

#include <filesystem>
#include <vector>

#include "app/options.hpp"
#include "engine/platform/program.hpp"

namespace sonde::app {
namespace {

namespace fs = std::filesystem;

/// Profiles of the installed program; in a build folder a link leads to those of the source tree.
std::vector<fs::path> profile_folders() {
  return {program_file().parent_path() / "../share/sonde/devices"};
}

}  // namespace

DeviceProfile device_named(const std::string& id) {
  const std::vector<fs::path> folders = profile_folders();
  try {
    return find_device_profile(id, folders);
  } catch (const UnknownProfile& error) {
    std::string known;
    for (const std::string& each : device_profile_ids(folders)) known += " " + each;
    throw UsageError(error.what() + ("; known are:" + known));
  }
}

}  // namespace sonde::app
