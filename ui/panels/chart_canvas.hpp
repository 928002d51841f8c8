// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>

class vtkChartXY;
class vtkContextScene;

namespace sonde::ui {

/// A widget that VTK's charts are drawn in, behind its children, by Qt's painter. The mouse is the
/// widget's own.
class ChartCanvas : public QWidget {
 public:
  explicit ChartCanvas(QWidget* parent);
  ~ChartCanvas() override;

  QImage picture() const;

 protected:
  /// What is drawn.
  vtkContextScene& scene() const;
  /// Arranges the charts now and draws them next; where they are not seen, when they are.
  void redraw();
  /// Gives the charts their places and the theme's colours. VTK's lengths are device pixels:
  /// `ratio` to one of Qt's.
  virtual void arrange(double ratio) = 0;
  /// Puts the axes of a chart, whose size that is, round that place in Qt's pixels.
  void place_chart(vtkChartXY& chart, const QRectF& within, double ratio) const;

  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Drawing;
  void draw_on(QPaintDevice& device) const;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace sonde::ui
