// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/painter_device.hpp"

#include <vtkBrush.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkObjectFactory.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace sonde::ui {
namespace {

QColor qt_colour(const vtkColor4ub& c) {
  return {c.GetRed(), c.GetGreen(), c.GetBlue(), c.GetAlpha()};
}

Qt::PenStyle style_of(int line) {
  switch (line) {
    case vtkPen::NO_PEN:
      return Qt::NoPen;
    case vtkPen::DASH_LINE:
      return Qt::DashLine;
    case vtkPen::DOT_LINE:
      return Qt::DotLine;
    case vtkPen::DASH_DOT_LINE:
      return Qt::DashDotLine;
    case vtkPen::DASH_DOT_DOT_LINE:
      return Qt::DashDotDotLine;
    default:
      return Qt::SolidLine;
  }
}

QTransform transform_of(vtkMatrix3x3& m) {
  return {m.GetElement(0, 0), m.GetElement(1, 0), m.GetElement(2, 0),
          m.GetElement(0, 1), m.GetElement(1, 1), m.GetElement(2, 1),
          m.GetElement(0, 2), m.GetElement(1, 2), m.GetElement(2, 2)};
}

/// VTK's rows are from below.
QImage image_of(vtkImageData& image) {
  const int wide = image.GetDimensions()[0], high = image.GetDimensions()[1];
  const int components = image.GetNumberOfScalarComponents();
  if (image.GetScalarType() != VTK_UNSIGNED_CHAR || components < 3) return {};
  const auto* bytes = static_cast<const unsigned char*>(image.GetScalarPointer());
  const auto format = components == 3 ? QImage::Format_RGB888 : QImage::Format_RGBA8888;
  return QImage(bytes, wide, high, components * wide, format).mirrored();
}

}  // namespace

vtkStandardNewMacro(PainterDevice);

void PainterDevice::paint_on(QPainter& painter, const QSize& size, const QFont& font,
                             double ratio) {
  painter_ = &painter;
  this->Geometry[0] = size.width();
  this->Geometry[1] = size.height();
  font_ = font;
  ratio_ = ratio;
  to_device_ = QTransform();
  pushed_.clear();
  clip_ = QRect(QPoint(), size);
  painter.setRenderHint(QPainter::Antialiasing);
}

void PainterDevice::let_go() { painter_ = nullptr; }

QPointF PainterDevice::placed(float x, float y) const {
  const QPointF at = to_device_.map(QPointF(x, y));
  return {at.x(), this->Geometry[1] - at.y()};
}

QPolygonF PainterDevice::placed(const float* points, int n) const {
  QPolygonF out;
  out.reserve(n);
  for (int i = 0; i < n; ++i) {
    const QPointF at = placed(points[2 * i], points[2 * i + 1]);
    if (std::isfinite(at.x()) && std::isfinite(at.y())) out << at;
  }
  return out;
}

void PainterDevice::take_pen() {
  QPen pen(qt_colour(this->Pen->GetColorObject()),
           std::max(1.0F, std::round(this->Pen->GetWidth())), style_of(this->Pen->GetLineType()));
  pen.setCapStyle(Qt::FlatCap);
  pen.setJoinStyle(Qt::BevelJoin);  // a spike would stand out of a noisy curve
  painter_->setPen(pen);
  painter_->setBrush(Qt::NoBrush);
}

void PainterDevice::fill(const QPolygonF& area) {
  painter_->setPen(Qt::NoPen);
  painter_->setBrush(qt_colour(this->Brush->GetColorObject()));
  painter_->setRenderHint(QPainter::Antialiasing, false);  // no seams between neighbours
  painter_->drawPolygon(area);
  painter_->setRenderHint(QPainter::Antialiasing);
}

/// What has no place breaks the line.
void PainterDevice::DrawPoly(float* points, int n, unsigned char* /*colors*/, int /*components*/) {
  take_pen();
  QPolygonF run;
  for (int i = 0; i < n; ++i) {
    const QPolygonF next = placed(points + 2 * i, 1);
    run += next;
    if (!next.isEmpty() && i + 1 < n) continue;
    stroke(run);
    run.clear();
  }
}

/// In whole pixels: a thin line that is spread over two rows of them is hard to see.
void PainterDevice::stroke(const QPolygonF& line) {
  painter_->setRenderHint(QPainter::Antialiasing, false);
  painter_->drawPolyline(line);
  painter_->setRenderHint(QPainter::Antialiasing);
}

void PainterDevice::DrawLines(float* points, int n, unsigned char* /*colors*/, int /*components*/) {
  take_pen();
  for (int i = 0; i + 1 < n; i += 2) stroke(placed(points + 2 * i, 2));
}

void PainterDevice::DrawPoints(float* points, int n, unsigned char* colors, int components) {
  DrawMarkers(VTK_MARKER_CIRCLE, false, points, n, colors, components);
}

void PainterDevice::DrawPointSprites(vtkImageData* /*sprite*/, float* points, int n,
                                     unsigned char* colors, int components) {
  DrawPoints(points, n, colors, components);
}

/// As large as the pen is wide.
void PainterDevice::DrawMarkers(int shape, bool /*highlight*/, float* points, int n,
                                unsigned char* /*colors*/, int /*components*/) {
  const double r = 0.5 * this->Pen->GetWidth();
  const QColor colour = qt_colour(this->Pen->GetColorObject());
  const bool lines = shape == VTK_MARKER_CROSS || shape == VTK_MARKER_PLUS;
  painter_->setPen(lines ? QPen(colour, ratio_) : QPen(Qt::NoPen));
  painter_->setBrush(colour);
  for (const QPointF& at : placed(points, n)) {
    const QPointF right(r, 0), up(0, r);
    switch (shape) {
      case VTK_MARKER_CIRCLE:
        painter_->drawEllipse(at, r, r);
        break;
      case VTK_MARKER_SQUARE:
        painter_->drawRect(QRectF(at - right - up, at + right + up));
        break;
      case VTK_MARKER_DIAMOND:
        painter_->drawPolygon(QPolygonF({at - right, at - up, at + right, at + up}));
        break;
      case VTK_MARKER_CROSS:
        painter_->drawLine(at - right - up, at + right + up);
        painter_->drawLine(at - right + up, at + right - up);
        break;
      default:
        painter_->drawLine(at - right, at + right);
        painter_->drawLine(at - up, at + up);
    }
  }
}

void PainterDevice::DrawQuad(float* points, int n) { fill(placed(points, n)); }

void PainterDevice::DrawQuadStrip(float* points, int n) {
  for (int i = 0; i + 3 < n; i += 2) {
    const QPolygonF strip = placed(points + 2 * i, 4);
    if (strip.size() == 4) fill(QPolygonF({strip[0], strip[1], strip[3], strip[2]}));
  }
}

void PainterDevice::DrawColoredPolygon(float* points, int n, unsigned char* /*colors*/,
                                       int /*components*/) {
  fill(placed(points, n));
}

void PainterDevice::DrawEllipseWedge(float x, float y, float outer_x, float outer_y, float inner_x,
                                     float inner_y, float start, float stop) {
  const QPointF at = placed(x, y);
  const QRectF outer(at - QPointF(outer_x, outer_y), at + QPointF(outer_x, outer_y));
  const QRectF inner(at - QPointF(inner_x, inner_y), at + QPointF(inner_x, inner_y));
  QPainterPath path;
  path.arcMoveTo(outer, start);
  path.arcTo(outer, start, stop - start);
  path.arcTo(inner, stop, start - stop);
  path.closeSubpath();
  painter_->fillPath(path, qt_colour(this->Brush->GetColorObject()));
}

void PainterDevice::DrawEllipticArc(float x, float y, float radius_x, float radius_y, float start,
                                    float stop) {
  const QPointF at = placed(x, y);
  QPainterPath path;
  const QRectF all(at - QPointF(radius_x, radius_y), at + QPointF(radius_x, radius_y));
  path.arcMoveTo(all, start);
  path.arcTo(all, start, stop - start);
  take_pen();
  painter_->drawPath(path);
}

QFont PainterDevice::text_font() const {
  QFont font = font_;
  font.setPixelSize(std::max(1, int(std::lround(this->TextProp->GetFontSize() * ratio_))));
  font.setBold(this->TextProp->GetBold() != 0);
  return font;
}

/// The point is the corner, or the middle, that the text is justified to, however it is turned.
void PainterDevice::DrawString(float* point, const vtkStdString& string) {
  const QFont font = text_font();
  const QFontMetricsF metrics(font);
  const QString text = QString::fromStdString(string);
  const double wide = metrics.horizontalAdvance(text);
  const int across = this->TextProp->GetJustification(),
            up = this->TextProp->GetVerticalJustification();
  const double left = across == VTK_TEXT_LEFT ? 0 : across == VTK_TEXT_RIGHT ? -wide : -wide / 2;
  const double base = up == VTK_TEXT_BOTTOM ? -metrics.descent()
                      : up == VTK_TEXT_TOP  ? metrics.ascent()
                                            : (metrics.ascent() - metrics.descent()) / 2;
  double rgb[3];
  this->TextProp->GetColor(rgb);
  painter_->save();
  painter_->setFont(font);
  painter_->setPen(QColor::fromRgbF(rgb[0], rgb[1], rgb[2], this->TextProp->GetOpacity()));
  painter_->translate(placed(point[0], point[1]));
  painter_->rotate(-this->TextProp->GetOrientation());
  painter_->drawText(QPointF(left, base), text);
  painter_->restore();
}

/// x, y, width and height.
void PainterDevice::ComputeStringBounds(const vtkStdString& string, float bounds[4]) {
  const QFontMetricsF metrics(text_font());
  const double wide = metrics.horizontalAdvance(QString::fromStdString(string));
  const QRectF turned = QTransform()
                            .rotate(-this->TextProp->GetOrientation())
                            .mapRect(QRectF(0, 0, wide, metrics.ascent() + metrics.descent()));
  bounds[0] = bounds[1] = 0;
  bounds[2] = float(turned.width());
  bounds[3] = float(turned.height());
}

void PainterDevice::DrawString(float* /*point*/, const vtkUnicodeString& /*string*/) {}

void PainterDevice::ComputeStringBounds(const vtkUnicodeString& /*string*/, float bounds[4]) {
  std::fill(bounds, bounds + 4, 0.0F);
}

void PainterDevice::ComputeJustifiedStringBounds(const char* string, float bounds[4]) {
  ComputeStringBounds(vtkStdString(string), bounds);
}

void PainterDevice::DrawMathTextString(float* point, const vtkStdString& string) {
  DrawString(point, string);
}

void PainterDevice::DrawImage(float point[2], float scale, vtkImageData* image) {
  const int* size = image->GetDimensions();
  DrawImage(vtkRectf(point[0], point[1], scale * float(size[0]), scale * float(size[1])), image);
}

void PainterDevice::DrawImage(const vtkRectf& place, vtkImageData* image) {
  const QRectF within(placed(place.GetX(), place.GetY() + place.GetHeight()),
                      placed(place.GetX() + place.GetWidth(), place.GetY()));
  painter_->drawImage(within, image_of(*image));
}

void PainterDevice::SetColor4(unsigned char color[4]) { this->Pen->SetColor(color); }

void PainterDevice::SetTexture(vtkImageData* /*image*/, int /*properties*/) {}

void PainterDevice::SetPointSize(float size) { this->Pen->SetWidth(size); }

void PainterDevice::SetLineWidth(float width) { this->Pen->SetWidth(width); }

void PainterDevice::SetLineType(int type) { this->Pen->SetLineType(type); }

void PainterDevice::SetMatrix(vtkMatrix3x3* m) { to_device_ = transform_of(*m); }

void PainterDevice::GetMatrix(vtkMatrix3x3* m) {
  const QTransform& t = to_device_;
  const double rows[9] = {t.m11(), t.m21(), t.m31(), t.m12(), t.m22(),
                          t.m32(), t.m13(), t.m23(), t.m33()};
  m->DeepCopy(rows);
}

void PainterDevice::MultiplyMatrix(vtkMatrix3x3* m) { to_device_ = transform_of(*m) * to_device_; }

void PainterDevice::PushMatrix() { pushed_.push_back(to_device_); }

void PainterDevice::PopMatrix() {
  if (pushed_.empty()) return;
  to_device_ = pushed_.back();
  pushed_.pop_back();
}

void PainterDevice::SetClipping(int* box) {
  clip_ = QRect(box[0], this->Geometry[1] - box[1] - box[3], box[2], box[3]);
}

void PainterDevice::EnableClipping(bool enable) {
  if (enable)
    painter_->setClipRect(clip_);
  else
    painter_->setClipping(false);
}

}  // namespace sonde::ui
