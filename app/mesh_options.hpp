// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "engine/base/error.hpp"

namespace sonde {
struct Body;
}

namespace sonde::app {

/// How a mesh that stands alone is read.
struct MeshOptions {
  std::string model = "auto";
  std::string repair = "auto";
  std::string unit = "m";
  double scale = 1;
  std::optional<double> allowance, safety;  ///< m
};
/// `whose`: as in add_offsets(): "the body".
void add_flags(CLI::App& parser, MeshOptions& options, const std::string& whose);

/// Throws InputError as read_body().
std::shared_ptr<const Body> load(const std::string& mesh, const MeshOptions& options,
                                 const Progress& progress);

}  // namespace sonde::app
