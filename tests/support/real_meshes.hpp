// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/body/body.hpp"

namespace sonde::test {

/// The path of a real mesh of Debian's libcgal-demo, such as "camel.off"; real_meshes.cmake unpacks
/// them into the build tree. Throws, saying what to install, where it is missing: a test that needs
/// one then fails, rather than passing for having looked at nothing.
std::filesystem::path real_mesh(const std::string& name);

/// The body of that mesh, whose unit is taken for the metre.
std::shared_ptr<const Body> real_body(const std::string& name);

/// All of them, in alphabetical order.
std::vector<std::filesystem::path> real_meshes();

}  // namespace sonde::test
