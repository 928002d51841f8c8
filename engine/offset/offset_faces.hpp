// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "engine/body/body.hpp"

namespace sonde {

/// A body with each face moved by `by` (m) along its normal: outwards where positive, inwards where
/// negative. How corners go: move_faces.hpp. Name, model and mass stay those of the body given, but
/// for R. Throws InputError where the body is a surface, `by` is not finite or leads beyond 1e30 m,
/// or the body is thinner somewhere than twice as much and would be inside out; Cancelled.
std::shared_ptr<const Body> offset_faces(const Body& body, double by,
                                         const Progress& progress = {});

/// "taken 10 µm smaller (allowance)", with what could not be moved as far; empty where the faces
/// are those of the mesh.
std::string offset_words(const FaceOffset& offset);

}  // namespace sonde
