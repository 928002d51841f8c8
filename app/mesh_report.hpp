// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/penetration/contact/clearance.hpp"

namespace sonde::app {

/// A mesh to report on.
struct MeshReport {
  std::string file;
  const Body& body;
};

/// How two meshes lie to each other, as in their files.
struct Between {
  Clearance clearance;
  std::optional<double> depth;  ///< √PD_g, m, where they overlap and it could be found
};
/// No value where they lie too far away to compute with.
std::optional<Between> between(const std::shared_ptr<const Body>& first,
                               const std::shared_ptr<const Body>& second, const Progress& progress);

/// For the user: one block for each mesh, six digits, with units; of two meshes, how far they are
/// apart, or how deep they overlap.
std::string to_text(const std::vector<MeshReport>& reports,
                    const std::optional<Between>& between = {});
/// {"units": {...}, "meshes": [{...}, ...]}, every digit; of two meshes also "clearance".
std::string to_json(const std::vector<MeshReport>& reports,
                    const std::optional<Between>& between = {});

}  // namespace sonde::app
