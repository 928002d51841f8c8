// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>
#include <string>

#include "engine/geometry/soup.hpp"
#include "tests/support/temp_folder.hpp"

namespace sonde::test {

// The formats as their specifications have them, written without any of the code under test.

inline std::ostringstream exact_stream() {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(17);
  return out;
}

inline void put_polygons(std::ostream& out, const PolygonSoup& soup, const char* start, bool count,
                         std::size_t base) {
  for (const auto& polygon : soup.polygons) {
    out << start;
    if (count) out << polygon.size();
    for (const std::size_t i : polygon) out << ' ' << i + base;
    out << '\n';
  }
}

template <class T>
std::string raw(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big))
    bytes.assign(bytes.rbegin(), bytes.rend());
  return bytes;
}

inline std::string as_off(const PolygonSoup& soup) {
  auto out = exact_stream();
  out << "OFF\n" << soup.points.size() << ' ' << soup.polygons.size() << " 0\n";
  for (const Vec3& x : soup.points) out << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
  put_polygons(out, soup, "", true, 0);
  return out.str();
}

/// As Geomview has it: 32 bits each, big-endian, after each face a number of colour values.
inline std::string as_binary_off(const PolygonSoup& soup, const std::string& keyword = "OFF",
                                 int more_of_vertex = 0, int colours = 0) {
  const auto whole = [](std::size_t n) { return raw(static_cast<std::int32_t>(n), true); };
  const auto floats = [](int n) {
    std::string out;
    for (int i = 0; i < n; ++i) out += raw(0.5F, true);
    return out;
  };
  std::string out =
      keyword + " BINARY\n" + whole(soup.points.size()) + whole(soup.polygons.size()) + whole(0);
  for (const Vec3& x : soup.points) {
    for (const double c : x) out += raw(static_cast<float>(c), true);
    out += floats(more_of_vertex);
  }
  for (const auto& polygon : soup.polygons) {
    out += whole(polygon.size());
    for (const std::size_t i : polygon) out += whole(i);
    out += whole(static_cast<std::size_t>(colours)) + floats(colours);
  }
  return out;
}

inline std::string as_obj(const PolygonSoup& soup) {
  auto out = exact_stream();
  for (const Vec3& x : soup.points) out << "v " << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
  put_polygons(out, soup, "f", false, 1);
  return out.str();
}

inline std::string ply_header(const PolygonSoup& soup, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
         std::to_string(soup.points.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(soup.polygons.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string as_text_ply(const PolygonSoup& soup) {
  auto out = exact_stream();
  out << ply_header(soup, "ascii");
  for (const Vec3& x : soup.points) out << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
  put_polygons(out, soup, "", true, 0);
  return out.str();
}

inline std::string as_binary_ply(const PolygonSoup& soup, bool big_endian) {
  std::string out = ply_header(soup, big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const Vec3& x : soup.points)
    for (const double c : x) out += raw(c, big_endian);
  for (const auto& polygon : soup.polygons) {
    out += static_cast<char>(polygon.size());
    for (const std::size_t i : polygon) out += raw(static_cast<std::int32_t>(i), big_endian);
  }
  return out;
}

inline std::string as_text_stl(const PolygonSoup& soup) {
  auto out = exact_stream();
  out << "solid a test\n";
  for (const auto& t : soup.polygons) {
    out << "  facet normal 0 0 1\n    outer loop\n";
    for (const std::size_t i : t) {
      const Vec3& x = soup.points[i];
      out << "      vertex " << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
    }
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid a test\n";
  return out.str();
}

inline std::string as_binary_stl(const PolygonSoup& soup, const std::string& title = "a test") {
  std::string out = title;
  out.resize(80, ' ');
  out += raw(static_cast<std::uint32_t>(soup.polygons.size()));
  for (const auto& t : soup.polygons) {
    out += std::string(12, '\0');
    for (const std::size_t i : t)
      for (const double c : soup.points[i]) out += raw(static_cast<float>(c));
    out += std::string(2, '\0');
  }
  return out;
}

}  // namespace sonde::test
