// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/body/body.hpp"
#include "engine/mending/mend.hpp"

namespace sonde {

/// How a body becomes a solid or a surface. Each function takes a body with name, soup, topology
/// and degenerate set.

/// Whether mending could change anything: not for one closed piece whose edges have two triangles
/// each.
bool may_need_mending(const Body& body, const Progress& progress = {});

/// Removes the triangles without an area, and returns their number. Vertices stay.
std::size_t set_aside_degenerate(Soup& soup, const Progress& progress = {});

/// Decides by the mesh as it is: solid if it is closed and has a volume. A mesh that crosses itself
/// is mended, if `repair` allows it. Sets the results and the mass. Throws InputError if `asked` is
/// solid and the body cannot be.
/// @return As choose_mended.
std::vector<TriangleKind> choose_model(Body& body, Model asked, Repair repair,
                                       const Progress& progress = {});

/// Mends the mesh and decides for each part; `all` is its soup with the degenerate triangles. May
/// replace body.soup. Throws as choose_model does.
/// @return The kind of each triangle of body.soup; empty if none is loose.
std::vector<TriangleKind> choose_mended(Body& body, const Soup& all, Model asked,
                                        const Progress& progress = {});

}  // namespace sonde
