// SPDX-License-Identifier: GPL-3.0-or-later
// sonde-draw FILE: the picture of the manual in which the two depths differ, drawn from what the
// static search makes of it. A bar lies askew in a slot; bar and slot are prisms along z, the slot
// so long that the way out is in the plane.
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/penetration/search/static_search.hpp"

namespace sonde::draw {
namespace {

struct Box {
  Vec3 low, high;
};

const Box bar{{-0.006, -0.07, -0.025}, {0.006, 0.07, 0.025}};
/// Two walls and the floor, which reaches into both.
const std::vector<Box> slot = {{{-0.08, -0.16, -0.4}, {-0.02, 0, 0.4}},
                               {{0.02, -0.16, -0.4}, {0.08, 0, 0.4}},
                               {{-0.07, -0.16, -0.39}, {0.07, -0.135, 0.39}}};

const Pose device{Quat(Eigen::AngleAxisd(-20 * std::numbers::pi / 180, Vec3::UnitZ())),
                  Vec3(0, -0.06, 0)};

void add(PolygonSoup& soup, const Box& box) {
  const std::size_t first = soup.points.size();
  for (int i = 0; i < 8; ++i)
    soup.points.push_back({i & 1 ? box.high.x() : box.low.x(), i & 2 ? box.high.y() : box.low.y(),
                           i & 4 ? box.high.z() : box.low.z()});
  constexpr std::array<std::array<std::size_t, 4>, 6> faces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : faces)
    soup.polygons.push_back({first + face[0], first + face[1], first + face[2], first + face[3]});
}

std::string number(const char* format, double x) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, x);
  return text.data();
}

/// Pixels from metres; y goes down.
struct Panel {
  double middle;  ///< of the slot, px
  std::string at(const Vec3& x) const {
    return number("%.1f", middle + 1800 * x.x()) + "," + number("%.1f", 150 - 1800 * x.y());
  }
  std::string box(const Box& b, const Pose& X, const std::string& style) const {
    std::string points;
    for (const Vec3& x : {Vec3(b.low.x(), b.low.y(), 0), Vec3(b.high.x(), b.low.y(), 0),
                          Vec3(b.high.x(), b.high.y(), 0), Vec3(b.low.x(), b.high.y(), 0)})
      points += at(X * x) + " ";
    return "<polygon points=\"" + points + "\" " + style + "/>\n";
  }
  std::string dot(const Vec3& x, const std::string& colour) const {
    const std::string p = at(x);
    const auto comma = p.find(',');
    return "<circle cx=\"" + p.substr(0, comma) + "\" cy=\"" + p.substr(comma + 1) +
           "\" r=\"4\" fill=\"" + colour + "\"/>\n";
  }
  std::string text(double y, const std::string& style, const std::string& words) const {
    return "<text x=\"" + number("%.1f", middle) + "\" y=\"" + number("%.0f", y) +
           "\" text-anchor=\"middle\" " + style + ">" + words + "</text>\n";
  }
};

std::string panel(double middle, const std::string& title, const Separation& s) {
  const Panel p{middle};
  std::string out = p.text(28, "font-size=\"15\" font-weight=\"bold\"", title);
  for (const Box& b : slot) out += p.box(b, {}, "fill=\"#b8bcc4\"");
  out += p.box(bar, device,
               "fill=\"#d2562d\" fill-opacity=\"0.3\" stroke=\"#d2562d\" "
               "stroke-dasharray=\"5 3\" stroke-width=\"1.5\"");
  out += p.box(bar, s.separated,
               "fill=\"#2f7fd0\" fill-opacity=\"0.55\" stroke=\"#1b4f86\" "
               "stroke-width=\"1.5\"");
  out += "<polyline points=\"" + p.at(device.p) + " " + p.at(s.separated.p) +
         "\" fill=\"none\" stroke=\"black\" stroke-width=\"2\"/>\n";
  out += p.dot(device.p, "#d2562d") + p.dot(s.separated.p, "#1b4f86");
  const double turn = s.device.q.angularDistance(s.separated.q) * 180 / std::numbers::pi;
  out += p.text(464, "font-size=\"14\"", "√σ = " + number("%.1f", 1e3 * s.depth) + " mm");
  return out + p.text(484, "",
                      "centre of mass moved " + number("%.1f", 1e3 * s.translation) +
                          " mm, turned " + number("%.1f", turn) + "°");
}

std::string picture() {
  PolygonSoup probe, fixed;
  add(probe, bar);
  for (const Box& b : slot) add(fixed, b);
  const Pair pair(make_body(probe, Model::solid, "bar"), make_body(fixed, Model::solid, "slot"));
  StaticOptions options;
  const Separation pdg = separate_static(pair, device, options);
  options.method = Method::pdt;
  const Separation pdt = separate_static(pair, device, options);
  for (const Separation& s : {pdg, pdt})
    if (s.status != Status::penetrating) throw std::runtime_error(s.reason);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"720\" height=\"500\" "
         "font-family=\"sans-serif\" font-size=\"12\" stroke=\"none\">\n"
         "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" +
         panel(180, "Translation alone: PD_t", pdt) + panel(540, "A turn allowed: PD_g", pdg) +
         "</svg>\n";
}

}  // namespace
}  // namespace sonde::draw

int main(int argc, char** argv) {
  if (argc != 2 || argv[1][0] == '-') {
    std::fputs("usage: sonde-draw FILE   (gets the picture of the two depths, SVG)\n", stderr);
    return 2;
  }
  try {
    std::ofstream file(argv[1], std::ios::binary);
    file << sonde::draw::picture();
    if (!file.flush()) throw std::runtime_error(std::string(argv[1]) + ": cannot be written");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sonde-draw: %s\n", error.what());
    return 4;
  }
}
