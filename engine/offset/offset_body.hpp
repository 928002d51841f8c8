// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "engine/body/body.hpp"

namespace sonde {

// offset_body itself is of the public face (engine/sonde.hpp): the same declaration.

/// A body with each face moved by `by` (m) along its normal: outwards where positive, inwards where
/// negative. Its mass stays that of the body given.
std::shared_ptr<const Body> offset_body(const Body& body, double by, const Progress& progress = {});

/// "the probe is taken 10 µm smaller (allowance)", of a body that is named so, with what could not
/// be moved as far; empty where its faces are those of its mesh.
std::string offset_text(const std::string& which, const FaceOffset& offset);

}  // namespace sonde
