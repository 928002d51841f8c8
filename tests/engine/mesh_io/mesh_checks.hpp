// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/error.hpp"
#include "engine/mesh_io/read_mesh.hpp"
#include "tests/engine/mesh_io/mesh_files.hpp"
#include "tests/support/shapes.hpp"

namespace sonde::test {

inline PolygonSoup read_bytes_as(const std::string& name, const std::string& bytes) {
  const TempFolder folder;
  return read_mesh(folder.write(name, bytes));
}

/// Why a file is refused, without its name; "accepted" where it is not.
inline std::string refusal_of(const std::string& name, const std::string& bytes) {
  const TempFolder folder;
  const auto file = folder.write(name, bytes);
  try {
    read_mesh(file);
  } catch (const InputError& error) {
    return std::string(error.what()).substr(file.string().size());
  }
  return "accepted";
}

/// The same points and polygons in the same order, to the bit.
inline void expect_same_mesh(const PolygonSoup& got, const PolygonSoup& want,
                             const std::string& what) {
  EXPECT_EQ(got.points, want.points) << what;
  EXPECT_EQ(got.polygons, want.polygons) << what;
}

/// A file that is read as `want`, with just these remarks.
inline void expect_read(const std::string& name, const std::string& bytes, const PolygonSoup& want,
                        const std::vector<std::string>& remarks = {}) {
  try {
    const PolygonSoup got = read_bytes_as(name, bytes);
    expect_same_mesh(got, want, bytes.substr(0, 200));
    EXPECT_EQ(got.remarks, remarks) << bytes.substr(0, 200);
  } catch (const InputError& error) {
    ADD_FAILURE() << error.what() << "\n" << bytes.substr(0, 200);
  }
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != text.npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

/// Several shapes of triangles, of a size that needs no remark, whose coordinates fit into single
/// precision.
inline std::vector<PolygonSoup> dialect_meshes() {
  std::vector<PolygonSoup> out = {tetrahedron(1), sphere(0.5, 5, 7), torus(1, 0.25, 6, 5)};
  for (PolygonSoup& mesh : out)
    for (Vec3& x : mesh.points)
      for (double& c : x) c = std::round(c * 1024) / 1024;
  return out;
}

/// Lines without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    out.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return out;
}

/// UTF-16 of ASCII.
inline std::string utf16_of(const std::string& text, bool big_endian, bool mark) {
  std::string out = mark ? (big_endian ? "\xfe\xff" : "\xff\xfe") : "";
  for (const char c : text) {
    if (big_endian) out += '\0';
    out += c;
    if (!big_endian) out += '\0';
  }
  return out;
}

}  // namespace sonde::test
