// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "engine/body/body.hpp"

namespace sonde::app {

/// A mesh to report on.
struct MeshReport {
  std::string file;
  const Body& body;
};

/// For the user: one block for each mesh, six digits, with units; of two meshes, how far they are
/// apart as they lie.
std::string to_text(const std::vector<MeshReport>& reports);
/// {"units": {...}, "meshes": [{...}, ...]}, every digit; of two meshes also "clearance".
std::string to_json(const std::vector<MeshReport>& reports);

}  // namespace sonde::app
