// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "engine/base/error.hpp"

namespace sonde {

/// A mesh file that has been checked, as it goes to CGAL: without what CGAL would trip over
/// (comments, colours, normals, unknown elements), and with the counts that must come out.
struct CheckedMesh {
  std::string text;
  std::size_t points = 0;  ///< 0: not known before
  std::size_t polygons = 0;
};

/// Each throws InputError with the line (or byte, in binary data) of the first fault it finds:
/// counts the file cannot hold or does not, words that are no numbers, coordinates that are not
/// finite, indices out of range, more data than declared.
CheckedMesh check_off(const std::string& file, std::string_view text, const Progress& progress);
CheckedMesh check_obj(const std::string& file, std::string_view text, const Progress& progress);
CheckedMesh check_ply(const std::string& file, std::string_view text, const Progress& progress);
CheckedMesh check_text_stl(const std::string& file, std::string_view text,
                           const Progress& progress);

}  // namespace sonde
