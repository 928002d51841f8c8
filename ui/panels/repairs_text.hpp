// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "engine/body/body.hpp"

namespace sonde::ui {

/// What was done to a mesh, in a few words each: "3 triangles turned, 2 openings closed". For what
/// could be a solid and is none, that. Empty where there is nothing to say; that parts overlap
/// changes no mesh.
QString repairs_in_brief(const Body& body);

/// The same in full sentences, a line each.
QString repairs_in_full(const Body& body);

/// What was done at a place: "opening closed".
QString words(RepairKind kind);

}  // namespace sonde::ui
