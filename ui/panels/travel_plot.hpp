// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "ui/base/format.hpp"

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
class TravelPlot : public QWidget {
 public:
  explicit TravelPlot(QWidget* parent);
  void set_curves(TravelCurves curves, const LengthUnit& unit);
  void show_at(std::optional<double> travel);
  std::function<void(double travel)> sought;
  QSize sizeHint() const override { return {240, 230}; }
  QSize minimumSizeHint() const override { return {200, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  struct Strip;
  std::vector<Strip> strips() const;
  double x_of(double travel) const;
  void draw(QPainter& painter, const Strip& strip) const;
  void seek(double x);

  TravelCurves curves_;
  LengthUnit unit_;
  std::optional<double> at_;
};

}  // namespace sonde::ui
