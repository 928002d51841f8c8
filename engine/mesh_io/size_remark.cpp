// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/mesh_io/size_remark.hpp"

#include <charconv>
#include <cmath>
#include <string>

#include "engine/text/file_unit.hpp"

namespace sonde {
namespace {

constexpr double smallest_sensible = 100e-6;  // m

/// The likely ones first.
constexpr const char* likely_units[] = {"mm", "m", "um"};

std::string four_digits(double x) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, x, std::chars_format::general, 4).ptr;
  return {text, end};
}

bool is_sensible(double metres) { return metres >= smallest_sensible && metres < hardly_metres; }

double largest_side(const PolygonSoup& soup) {
  Vec3 low = soup.points.front(), high = low;
  for (const Vec3& x : soup.points) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

}  // namespace

void remark_on_size(PolygonSoup& soup, double scale) {
  const double size = largest_side(soup);
  if (is_sensible(size) || size == 0) return;
  std::string text = "the mesh is " +
                     (size < 1 ? four_digits(size * 1e6) + " um" : four_digits(size) + " m") +
                     " long";
  for (const std::string name : likely_units) {
    if (scale == 0 || !is_sensible(size / scale * unit_in_metres(name).value())) continue;
    text.append(": in ").append(name).append(" it would be ");
    text.append(four_digits(size / scale)).append(" ").append(name);
    text.append("; give --unit ").append(name);
    soup.remarks.push_back(std::move(text));
    return;
  }
  soup.remarks.push_back(text + ": are its unit and scale right?");
}

}  // namespace sonde
