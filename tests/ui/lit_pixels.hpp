// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <cstdlib>
#include <vector>

namespace sonde::ui::test {

/// The columns (or rows) of a picture in which more than `least` pixels are about of that colour:
/// their red, green and blue differ by less than `within` together.
inline std::vector<int> lit_lines(const QImage& picture, Qt::Orientation lines,
                                  const QColor& colour, int within, int least) {
  const QImage image = picture.convertToFormat(QImage::Format_RGB32);
  const bool columns = lines == Qt::Vertical;
  std::vector<int> out;
  for (int i = 0; i < (columns ? image.width() : image.height()); ++i) {
    int count = 0;
    for (int j = 0; j < (columns ? image.height() : image.width()); ++j) {
      const QColor at(columns ? image.pixel(i, j) : image.pixel(j, i));
      count += std::abs(at.red() - colour.red()) + std::abs(at.green() - colour.green()) +
                   std::abs(at.blue() - colour.blue()) <
               within;
    }
    if (count > least) out.push_back(i);
  }
  return out;
}

}  // namespace sonde::ui::test
