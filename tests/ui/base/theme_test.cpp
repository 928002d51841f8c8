// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/theme.hpp"

#include <gtest/gtest.h>

#include <QPalette>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sonde::ui {
namespace {

/// Relative luminance and contrast of two colours, as the Web Content Accessibility Guidelines 2.1
/// define them; they ask for 4.5 of small text.
double luminance(const QColor& colour) {
  const auto linear = [](double x) {
    return x <= 0.03928 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  const double one = luminance(a) + 0.05, other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

TEST(Theme, faint_text_can_be_read_on_light_and_dark_windows_and_stands_back) {
  const QColor light_window(239, 239, 239), dark_window(36, 41, 48);
  for (const auto& [window, text] :
       {std::pair(light_window, QColor(Qt::black)), std::pair(dark_window, colour::text)}) {
    QPalette palette;
    palette.setColor(QPalette::Window, window);
    palette.setColor(QPalette::WindowText, text);
    const double faint = contrast(faint_text(palette), window);
    EXPECT_GT(faint, 4.5) << window.name().toStdString();
    EXPECT_LT(faint, contrast(text, window)) << window.name().toStdString();
  }
}

using Rgb = std::array<double, 3>;

Rgb linear(const QColor& colour) {
  const auto one = [](double x) {
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return {one(colour.redF()), one(colour.greenF()), one(colour.blueF())};
}

/// What people see who lack one of the three cones: Machado, Oliveira and Fernandes, "A
/// physiologically-based model for simulation of color vision deficiency" (2009), severity 1.
struct Seen {
  const char* by;
  std::array<Rgb, 3> rows;
};
const Seen ways_of_seeing[] = {{"all hues", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                               {"protan",
                                {{{0.152286, 1.052583, -0.204868},
                                  {0.114503, 0.786281, 0.099216},
                                  {-0.003882, -0.048116, 1.051998}}}},
                               {"deutan",
                                {{{0.367322, 0.860646, -0.227968},
                                  {0.280085, 0.672501, 0.047413},
                                  {-0.011820, 0.042940, 0.968881}}}},
                               {"tritan",
                                {{{1.255528, -0.076749, -0.178779},
                                  {-0.078411, 0.930809, 0.147602},
                                  {0.004733, 0.691367, 0.303900}}}}};

/// CIE L*a*b* (1976) under D65 of what is seen of a colour.
Rgb lab(const QColor& colour, const Seen& seen) {
  const Rgb in = linear(colour);
  Rgb c{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) c.at(i) += seen.rows.at(i).at(j) * in.at(j);
    c.at(i) = std::clamp(c.at(i), 0.0, 1.0);
  }
  const auto root = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = root((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.95047);
  const double y = root(0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]);
  const double z = root((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.08883);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// A difference of 2.3 is just noticed side by side; ten times that is another colour.
TEST(Theme, colours_of_the_picture_differ_for_those_who_see_fewer_hues) {
  const std::pair<const char*, QColor> all[] = {
      {"probe", colour::probe},     {"fixed", colour::fixed},      {"ghost", colour::ghost},
      {"contact", colour::contact}, {"force", colour::force},      {"torque", colour::torque},
      {"nearest", colour::nearest}, {"straight", colour::straight}};
  for (const Seen& seen : ways_of_seeing)
    for (const auto& [name, colour] : all)
      for (const auto& [other_name, other] : all) {
        if (&name == &other_name) continue;
        const Rgb a = lab(colour, seen), b = lab(other, seen);
        EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 23)
            << name << " and " << other_name << ", " << seen.by;
      }
}

/// What closes an opening is not taken for the body that it is part of.
TEST(Theme, caps_differ_from_the_bodies_for_those_who_see_fewer_hues) {
  for (const Seen& seen : ways_of_seeing)
    for (const QColor& body : {colour::probe, colour::fixed}) {
      const Rgb a = lab(colour::cap, seen), b = lab(body, seen);
      EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 23) << seen.by;
    }
}

TEST(Theme, colours_can_be_read_on_a_light_window_and_stay_on_a_dark_one) {
  QPalette light, dark;
  light.setColor(QPalette::Window, QColor(240, 242, 245));
  dark.setColor(QPalette::Window, QColor(36, 41, 48));
  for (const QColor& colour :
       {colour::ghost, colour::turn, colour::nearest, colour::straight, colour::force,
        colour::torque, colour::contact, colour::ready, colour::clearance}) {
    EXPECT_GE(contrast(readable(colour, light), light.color(QPalette::Window)), 4.5);
    EXPECT_EQ(readable(colour, dark), colour);
  }
  EXPECT_EQ(readable(colour::clearance, light), QColor(Qt::black)) << "as strong as white on dark";
}

TEST(Theme, labels_in_the_pictures_colours_can_be_read_on_it) {
  for (const QColor& colour : {colour::probe, colour::fixed, colour::ghost, colour::contact,
                               colour::force, colour::torque, colour::nearest, colour::straight})
    EXPECT_GT(contrast(colour, colour::background_bottom), 4.5) << colour.name().toStdString();
}

}  // namespace
}  // namespace sonde::ui
