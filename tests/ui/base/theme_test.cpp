// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/theme.hpp"

#include <gtest/gtest.h>

#include <QPalette>
#include <algorithm>
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

}  // namespace
}  // namespace sonde::ui
