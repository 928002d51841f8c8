// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/study/assembly/clash_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/geometry/transform.hpp"
#include "engine/study/charts/svg_elements.hpp"
#include "engine/text/number_text.hpp"

namespace sonde {
namespace {

using svg::Spot;

constexpr double side = 420, left = 20, top = 60;  // pixels, of the drawing
constexpr double around = 1.3;                     // view half width / the smaller part's radius
constexpr double least_arrow = 18;                 // pixels: a shorter way out is drawn that long
constexpr double mm_of_metre = 1e3;

/// The plane of a section: right and up in the picture, from the middle.
struct Section {
  Vec3 middle, right, up;
  double reach;  ///< m, from the middle to each side
  Spot at(const Vec3& x) const {
    const double scale = side / (2 * reach);
    return {left + side / 2 + scale * (x - middle).dot(right),
            top + side / 2 - scale * (x - middle).dot(up)};
  }
};

/// The direction in which the smaller part leaves the other, not normalised; zero if unknown.
Vec3 way_out(const AssemblyPart& part, const Clash& clash) {
  if (!clash.separated) return Vec3::Zero();
  const Vec3 x = inverse(part.X_WM) * *clash.place;  // the part's point there
  return *clash.separated * x - *clash.place;
}

/// A unit vector perpendicular to `along`: in the direction of `wanted`, or any.
Vec3 square_to(const Vec3& along, const Vec3& wanted) {
  Vec3 out = wanted - along * along.dot(wanted);
  if (!(out.norm() > 1e-6 * wanted.norm())) {
    Eigen::Index least = 0;
    along.cwiseAbs().minCoeff(&least);
    out = Vec3::Unit(least) - along * along[least];
  }
  return out.normalized();
}

Section section_of(const AssemblyPart& smaller, const AssemblyPart& other, const Clash& clash) {
  const Vec3& at = *clash.place;
  const Vec3 com = smaller.X_WM * smaller.body->mass.com;
  const Vec3 to_other = other.X_WM * other.body->mass.com - com;
  Vec3 up = way_out(smaller, clash);
  if (!(up.norm() > 0)) up = to_other.norm() > 0 ? Vec3(-to_other) : Vec3(Vec3::UnitZ());
  up.normalize();
  return {at, square_to(up, Vec3(com - at)), up,
          around * std::max(smaller.body->mass.radius, 1e-12)};
}

/// The segment in which a plane cuts a triangle; no value if it does not.
std::optional<std::array<Vec3, 2>> cut(const std::array<Vec3, 3>& t,
                                       const std::array<double, 3>& d) {
  std::array<Vec3, 2> ends;
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3 && count < 2; ++k) {
    const std::size_t n = (k + 1) % 3;
    if ((d[k] < 0) == (d[n] < 0)) continue;
    ends.at(count++) = t[k] + (t[n] - t[k]) * (d[k] / (d[k] - d[n]));
  }
  if (count < 2) return std::nullopt;
  return ends;
}

/// The lines in which the plane cuts a part, within the picture.
std::string outline(const Section& plane, const AssemblyPart& part, std::size_t colour) {
  const Vec3 normal = plane.right.cross(plane.up);
  const Soup& soup = part.body->soup;
  const Transform X(part.X_WM);
  std::string path;
  for (const Triangle& triangle : soup.triangles) {
    std::array<Vec3, 3> corners;
    std::array<double, 3> heights{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners.at(k) = X * soup.vertices[triangle[k]];
      heights.at(k) = normal.dot(corners.at(k) - plane.middle);
    }
    const auto ends = cut(corners, heights);
    if (!ends) continue;
    const Spot from = plane.at((*ends)[0]), to = plane.at((*ends)[1]);
    const auto [x0, x1] = std::minmax(from.x, to.x);
    const auto [y0, y1] = std::minmax(from.y, to.y);
    if (x1 < left || x0 > left + side || y1 < top || y0 > top + side) continue;
    path +=
        "M" + svg::px(from.x) + " " + svg::px(from.y) + "L" + svg::px(to.x) + " " + svg::px(to.y);
  }
  if (path.empty()) return {};
  return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + svg::series_color(colour) +
         "\" stroke-width=\"1.5\" clip-path=\"url(#section)\"/>\n";
}

std::string arrow(const Section& plane, const Vec3& way) {
  const double length = way.norm();
  if (!(length > 0)) return {};
  const Spot from = plane.at(plane.middle);
  const double drawn = std::max(least_arrow, length * side / (2 * plane.reach));
  const double x = from.x, y = from.y - drawn;  // the way out is upwards in the picture
  const std::string style = "stroke=\"#000\" stroke-width=\"1.5\"";
  return svg::line_of(x, from.y, x, y, style) + svg::line_of(x, y, x - 4, y + 7, style) +
         svg::line_of(x, y, x + 4, y + 7, style);
}

std::string length_text(double metres) { return number_text(metres * mm_of_metre, 4) + " mm"; }

std::string words(const Clash& clash) {
  std::string text = name_of(clash.kind);
  if (clash.depth && clash.fit)
    text += ", and held: the way out is " + length_text(*clash.depth);
  else if (clash.depth)
    text += ", " + length_text(*clash.depth) + " deep";
  if (clash.lower_bound) text += ", at least " + length_text(*clash.lower_bound);
  if (clash.clearance) text += ", " + length_text(*clash.clearance) + " apart";
  if (clash.kind == Clash::Kind::failed) text += std::string(": ") + clash.reason;
  return text;
}

}  // namespace

std::string clash_picture(const AssemblyPart& a, const AssemblyPart& b, const Clash& clash) {
  const bool first = clash.moved == clash.parts[0];
  const AssemblyPart& smaller = first ? a : b;
  std::string content = svg::text_at(left, 50, "start", words(clash));
  const double below = top + side + 20;
  if (clash.place) {
    const Section plane = section_of(smaller, first ? b : a, clash);
    content += "<clipPath id=\"section\">" +
               svg::rectangle(left, top, side, side, "/></clipPath>\n") +
               svg::rectangle(left, top, side, side, "fill=\"none\" stroke=\"#bbb\"/>\n") +
               outline(plane, a, 0) + outline(plane, b, 1) + arrow(plane, way_out(smaller, clash));
    const Spot at = plane.at(plane.middle);
    content += "<circle cx=\"" + svg::px(at.x) + "\" cy=\"" + svg::px(at.y) +
               "\" r=\"3\" fill=\"#000\"/>\n";
    const auto& p = *clash.place;
    content += svg::text_at(left, below + 40, "start",
                            "at " + length_text(p.x()) + ", " + length_text(p.y()) + ", " +
                                length_text(p.z())) +
               svg::text_at(left, below + 60, "start",
                            "the side of the picture is " + length_text(2 * plane.reach));
  } else {
    content += svg::text_at(left, top + 20, "start", "no place is known");
  }
  const std::array<const AssemblyPart*, 2> parts{&a, &b};
  for (std::size_t i = 0; i < 2; ++i)
    content += svg::text_at(left + 220 * static_cast<double>(i), below, "start", parts.at(i)->name,
                            " fill=\"" + svg::series_color(i) + "\"");
  if (clash.separated)
    content += svg::text_at(left, below + 20, "start",
                            "the arrow: " + smaller.name + " moves out by " +
                                length_text(way_out(smaller, clash).norm()) + " there");
  return svg::page(left + side + 20, below + 80, a.name + " and " + b.name, left, content);
}

}  // namespace sonde
