// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of any size, drawn beside the window's own.

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cstring>

#include "ui/views/scenery.hpp"

namespace sonde::ui {
namespace {

/// What OpenGL has drawn, which runs upwards. Translucent bodies are blended over black where there
/// is no background: that is what premultiplied means.
QImage drawn(vtkGenericOpenGLRenderWindow& window, const QSize& size) {
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, pixels);
  QImage image(size, QImage::Format_RGBA8888_Premultiplied);
  const auto row = static_cast<std::size_t>(size.width()) * 4;
  if (pixels->GetNumberOfValues() < static_cast<vtkIdType>(row) * size.height()) return {};
  for (int y = 0; y < size.height(); ++y)
    std::memcpy(image.scanLine(size.height() - 1 - y),
                pixels->GetPointer(static_cast<vtkIdType>(row) * y), row);
  return image;
}

}  // namespace

QSize Viewport::view_size() const { return scenery_->picture_size.value_or(size()); }

QImage Viewport::picture(const Instant& now, const PictureOptions& options) {
  Scenery& s = *scenery_;
  const bool sizable = options.size.width() > 0 && options.size.height() > 0 &&
                       std::max(options.size.width(), options.size.height()) <= largest_picture;
  if (!s.probe || !sizable || height() < 1) return {};
  const std::array<bool, std::tuple_size_v<decltype(s.shown)>> shown = s.shown;
  const bool gradient = s.bodies->GetGradientBackground();
  double background[3];
  s.bodies->GetBackground(background);
  const int *size = s.window->GetSize(), before[2] = {size[0], size[1]};

  // Glyphs and text keep their size beside the bodies: laid out for the view's own height.
  const double scale = double(options.size.height()) / height();
  s.picture_size = QSize(std::max(static_cast<int>(options.size.width() / scale), 1), height());
  if (!options.overlays) s.shown.fill(false);
  apply_layers();
  if (options.transparent) {
    s.bodies->GradientBackgroundOff();
    s.bodies->SetBackground(0, 0, 0);
    s.bodies->SetBackgroundAlpha(0);
    s.window->AlphaBitPlanesOn();
  }
  s.widget->makeCurrent();
  s.window->SetSize(options.size.width(), options.size.height());
  s.hints->setUpdatesEnabled(false);
  s.hints->set_hint_visible(false);  // how the mouse moves the probe belongs to the window
  const bool insists = s.hints->insists();
  s.hints->set_insists(true);
  s.hints->set_legend_visible(true);
  s.hints->resize(*s.picture_size);
  draw(now, options.swing);
  QImage image = drawn(*s.window, options.size);
  if (options.overlays && !image.isNull()) {
    QPainter painter(&image);
    painter.scale(scale, scale);
    s.hints->render(&painter, QPoint(), QRegion(), QWidget::DrawChildren);
  }

  s.shown = shown;
  s.picture_size.reset();
  s.hints->setGeometry(rect());
  s.hints->set_insists(insists);
  s.hints->set_hint_visible(this->shown(Layer::hint));
  s.hints->set_legend_visible(this->shown(Layer::hint));
  s.hints->setUpdatesEnabled(true);
  s.bodies->SetGradientBackground(gradient);
  s.bodies->SetBackground(background);
  s.bodies->SetBackgroundAlpha(1);
  s.window->SetSize(before[0], before[1]);
  apply_layers();
  draw(now, 1);
  invalidate();
  return image;
}

}  // namespace sonde::ui
