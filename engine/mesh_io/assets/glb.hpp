// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sonde {

/// What a GLB holds (glTF 2.0, "GLB File Format Specification").
struct Glb {
  std::string_view text;  ///< JSON
  std::string_view data;  ///< empty where there is none
};

/// The two chunks of a GLB; others may follow and are passed over. Throws InputError with the byte
/// where it is cut off, or of another version.
Glb chunks_of(const std::string& file, std::string_view bytes);

/// A GLB of these two.
std::string glb_of(std::string_view text, std::string_view data);

}  // namespace sonde
