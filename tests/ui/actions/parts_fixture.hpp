// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTreeWidget>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/ui/window_fixture.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/actions/parts_control.hpp"
#include "ui/panels/parts_panel.hpp"

namespace sonde::ui::test {

/// Three cubes of 0.1 m side by side, with gaps of 0.1 m; the probe is the same cube, 20 mm above
/// the first.
class PartsTest : public WindowTest {
 protected:
  enum Column { name, shown, felt, triangles };

  void SetUp() override {
    WindowTest::SetUp();
    const auto row = folder.write("row.sonde.json", R"({"format": 1, "unit": "m",
        "probe": {"mesh": "cube.off", "pose": [0, 0, 0.12, 1, 0, 0, 0]},
        "fixed": [{"name": "left", "mesh": "cube.off"},
                  {"name": "middle", "mesh": "cube.off", "pose": [0.2, 0, 0, 1, 0, 0, 0]},
                  {"name": "right", "mesh": "cube.off", "pose": [0.4, 0, 0, 1, 0, 0, 0]}]})");
    open({QString::fromStdString(row.string())});
    ASSERT_EQ(failed, 0) << (complaints.empty() ? "" : complaints[0].toStdString());
    rows = find<QTreeWidget>("part_rows");
    window->parts().panel().show();
    window->parts().panel().raise();
  }
  Document& document() { return window->documents().document(); }
  const Body& fixed() { return window->session()->fixed(); }
  void tick(int row, int column, bool on) {
    rows->topLevelItem(row)->setCheckState(column, on ? Qt::Checked : Qt::Unchecked);
  }
  /// Waits for what is read anew.
  bool steps(int count) {
    return wait_until([&] { return document().stack().index() == count; }) &&
           wait_until([&] { return window->shown().has_value(); });
  }
  /// How many pixels of the picture are of that colour, but for shading: as red, as green and as
  /// blue, in proportion.
  int pixels_like(const QColor& colour) {
    const QImage seen = picture();
    int count = 0;
    for (int y = 0; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x) {
        const QColor at = seen.pixelColor(x, y);
        const double light = at.value() / double(std::max(colour.value(), 1));
        count += light > 0.3 && std::abs(at.red() - light * colour.red()) < 6 &&
                 std::abs(at.green() - light * colour.green()) < 6 &&
                 std::abs(at.blue() - light * colour.blue()) < 6;
      }
    return count;
  }
  /// Two cubes of 0.1 m, 0.3 m apart, in one file.
  static std::string two_cubes() {
    std::string corners, faces;
    for (int k = 0; k < 2; ++k) {
      for (int i = 0; i < 8; ++i)
        corners += std::to_string(0.3 * k + ((i & 1) != 0 ? 0.05 : -0.05)) + " " +
                   ((i & 2) != 0 ? "0.05 " : "-0.05 ") + ((i & 4) != 0 ? "0.05\n" : "-0.05\n");
      for (const auto& f :
           {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
            std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
        faces += "4";
        for (const int corner : f) faces.append(" ").append(std::to_string(corner + 8 * k));
        faces += "\n";
      }
    }
    return "OFF\n16 12 0\n" + corners + faces;
  }
  Vec3 cut_normal() const { return window->viewport().seeing().cut.normal; }
  QTreeWidget* rows = nullptr;
};

}  // namespace sonde::ui::test
