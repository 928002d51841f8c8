// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkContextDevice2D.h>

#include <QFont>
#include <QTransform>
#include <vector>

class QPainter;
class QPointF;
class QPolygonF;

namespace sonde::ui {

/// What VTK's charts draw on, by a QPainter in place of OpenGL. A canvas of OpenGL costs a context
/// and the translation of its programs when it is seen first, which keeps a window waiting for some
/// tenths of a second. Colours of single points, textures and mathematical text are none of ours
/// and are not drawn.
class PainterDevice : public vtkContextDevice2D {
 public:
  static PainterDevice* New();
  vtkTypeMacro(PainterDevice, vtkContextDevice2D);

  /// Everything up to let_go() goes to that painter, whose unit is one device pixel. VTK's y is
  /// from below `high` up. `font`: the family of all text; `ratio` device pixels are one of its
  /// pixels.
  void paint_on(QPainter& painter, const QSize& size, const QFont& font, double ratio);
  void let_go();

  void DrawPoly(float* points, int n, unsigned char* colors, int components) override;
  void DrawLines(float* points, int n, unsigned char* colors, int components) override;
  void DrawPoints(float* points, int n, unsigned char* colors, int components) override;
  void DrawPointSprites(vtkImageData* sprite, float* points, int n, unsigned char* colors,
                        int components) override;
  void DrawMarkers(int shape, bool highlight, float* points, int n, unsigned char* colors,
                   int components) override;
  void DrawQuad(float* points, int n) override;
  void DrawQuadStrip(float* points, int n) override;
  void DrawColoredPolygon(float* points, int n, unsigned char* colors, int components) override;
  void DrawEllipseWedge(float x, float y, float outer_x, float outer_y, float inner_x,
                        float inner_y, float start, float stop) override;
  void DrawEllipticArc(float x, float y, float radius_x, float radius_y, float start,
                       float stop) override;
  void DrawString(float* point, const vtkStdString& string) override;
  void ComputeStringBounds(const vtkStdString& string, float bounds[4]) override;
  void DrawString(float* point, const vtkUnicodeString& string) override;
  void ComputeStringBounds(const vtkUnicodeString& string, float bounds[4]) override;
  void ComputeJustifiedStringBounds(const char* string, float bounds[4]) override;
  void DrawMathTextString(float* point, const vtkStdString& string) override;
  void DrawImage(float point[2], float scale, vtkImageData* image) override;
  void DrawImage(const vtkRectf& place, vtkImageData* image) override;
  void SetColor4(unsigned char color[4]) override;
  void SetTexture(vtkImageData* image, int properties) override;
  void SetPointSize(float size) override;
  void SetLineWidth(float width) override;
  void SetLineType(int type) override;
  void SetMatrix(vtkMatrix3x3* m) override;
  void GetMatrix(vtkMatrix3x3* m) override;
  void MultiplyMatrix(vtkMatrix3x3* m) override;
  void PushMatrix() override;
  void PopMatrix() override;
  void SetClipping(int* box) override;
  void EnableClipping(bool enable) override;

 protected:
  PainterDevice() = default;
  ~PainterDevice() override = default;

 private:
  QPointF placed(float x, float y) const;
  /// Those of n points that have a place.
  QPolygonF placed(const float* points, int n) const;
  void take_pen();
  void stroke(const QPolygonF& line);
  void fill(const QPolygonF& area);
  QFont text_font() const;

  QPainter* painter_ = nullptr;
  QFont font_;
  double ratio_ = 1;
  QTransform to_device_;  ///< VTK's, y from below
  std::vector<QTransform> pushed_;
  QRect clip_;
};

}  // namespace sonde::ui
