// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_canvas.hpp"

#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkNew.h>

#include <QEvent>
#include <QImage>
#include <QPainter>
#include <QPalette>

#include "ui/base/theme.hpp"
#include "ui/panels/painter_device.hpp"

namespace sonde::ui {

struct ChartCanvas::Drawing {
  vtkNew<vtkContextScene> scene;
  vtkNew<vtkContext2D> context;
  vtkNew<PainterDevice> device;
};

ChartCanvas::ChartCanvas(QWidget* parent) : QWidget(parent), drawing_(std::make_unique<Drawing>()) {
  setAttribute(Qt::WA_OpaquePaintEvent);
}

ChartCanvas::~ChartCanvas() = default;

void ChartCanvas::draw_on(QPaintDevice& device) const {
  const double ratio = devicePixelRatioF();
  const QSize pixels = size() * ratio;
  QPainter painter(&device);
  painter.fillRect(rect(), plot_background(palette()));
  painter.scale(1 / ratio, 1 / ratio);
  const Drawing& d = *drawing_;
  d.scene->SetGeometry(pixels.width(), pixels.height());
  d.device->paint_on(painter, pixels, font(), ratio);
  d.context->Begin(d.device);
  d.scene->Paint(d.context);
  d.context->End();
  d.device->let_go();
}

QImage ChartCanvas::picture() const {
  QImage image(size() * devicePixelRatioF(), QImage::Format_RGB32);
  image.setDevicePixelRatio(devicePixelRatioF());
  draw_on(image);
  return image;
}

vtkContextScene& ChartCanvas::scene() const { return *drawing_->scene; }

void ChartCanvas::redraw() {
  if (!isVisible()) return;
  arrange(devicePixelRatioF());
  update();
}

void ChartCanvas::place_chart(vtkChartXY& chart, const QRectF& within, double ratio) const {
  chart.SetSize(vtkRectf(float(within.left() * ratio), float((height() - within.bottom()) * ratio),
                         float(within.width() * ratio), float(within.height() * ratio)));
}

void ChartCanvas::paintEvent(QPaintEvent* /*event*/) { draw_on(*this); }

void ChartCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  redraw();
}

void ChartCanvas::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  redraw();
}

void ChartCanvas::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) redraw();
}

}  // namespace sonde::ui
