// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/mending/mend.hpp"

namespace sonde {

/// How a body comes to be a solid or a surface. Each step takes a body with name, soup, topology
/// and degenerate.

/// Whether mending could change anything: not in one closed piece whose edges have two triangles
/// each.
bool may_need_mending(const Body& body, const Progress& progress = {});

/// Removes the triangles without an area, and returns how many. Vertices stay.
std::size_t set_aside_degenerate(Soup& soup, const Progress& progress = {});

/// Decides by the mesh as it is: solid where it is closed and has a volume; one that crosses itself
/// is mended, where `repair` allows it. Fills in all that says so, and the mass. Throws InputError
/// where `asked` is solid and it cannot be.
/// @return As choose_mended.
std::vector<TriangleKind> choose_model(Body& body, Model asked, Repair repair,
                                       const Progress& progress = {});

/// Decides part by part by the mesh as it is once mended; `all` is its soup with the degenerate
/// triangles. May exchange body.soup. Throws as choose_model.
/// @return What each triangle of body.soup is for; empty where none is loose.
std::vector<TriangleKind> choose_mended(Body& body, const Soup& all, Model asked,
                                        const Progress& progress = {});

}  // namespace sonde
