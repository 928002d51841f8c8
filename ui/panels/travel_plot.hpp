// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/base/format.hpp"
#include "ui/panels/chart_canvas.hpp"

namespace sonde::ui {

/// What happens along a way, by how far it is along it.
struct TravelCurves {
  std::vector<double> travel;   ///< m, rising
  std::vector<double> room;     ///< m: the clearance, or minus the depth by which it is held back
  std::vector<double> force;    ///< N
  std::optional<double> first;  ///< m, where it first binds
};

/// Room and force along a way, one above the other, with a line where one is. A click or a drag
/// goes there.
class TravelPlot : public ChartCanvas {
  Q_OBJECT
 public:
  explicit TravelPlot(QWidget* parent);
  ~TravelPlot() override;
  void set_curves(TravelCurves curves, const LengthUnit& unit);
  void show_at(std::optional<double> travel);
  QSize sizeHint() const override { return {240, 250}; }
  QSize minimumSizeHint() const override { return {200, 180}; }

 signals:
  void sought(double travel);

 protected:
  void arrange(double ratio) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  struct Strip;
  double longest() const;  ///< m; 0 where there is no way
  void seek(double x);

  std::unique_ptr<Strip> room_, force_;  ///< from above
  TravelCurves curves_;
  LengthUnit unit_;
  std::optional<double> at_;
};

}  // namespace sonde::ui
