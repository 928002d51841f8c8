// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/painter_device.hpp"

#include <gtest/gtest.h>
#include <vtkBrush.h>
#include <vtkContext2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkRect.h>
#include <vtkTextProperty.h>
#include <vtkTransform2D.h>

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <limits>
#include <memory>

#include "tests/ui/window_fixture.hpp"

namespace sonde::ui::test {
namespace {

/// A sheet of 100 × 80 white pixels. References: the pixels by hand; VTK counts them from below.
class PainterDeviceTest : public testing::Test {
 protected:
  void SetUp() override {
    need_application();
    sheet.fill(Qt::white);
    painter = std::make_unique<QPainter>(&sheet);
    device->paint_on(*painter, sheet.size(), QFont(), 1);
    context->Begin(device);
    context->GetPen()->SetColor(255, 0, 0);
    context->GetPen()->SetWidth(1);
    context->GetBrush()->SetColor(0, 0, 255, 255);
  }
  void TearDown() override {
    context->End();
    device->let_go();
  }
  bool is(const QColor& colour, int x, int y_from_below) const {
    return sheet.pixelColor(x, 79 - y_from_below) == colour;
  }
  int count(const QColor& colour) const {
    int found = 0;
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 100; ++x) found += sheet.pixelColor(x, y) == colour;
    return found;
  }
  QRect inked() const {
    QRect box;
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 100; ++x)
        if (sheet.pixelColor(x, y) != Qt::white) box |= QRect(x, y, 1, 1);
    return box;
  }
  QImage sheet{100, 80, QImage::Format_RGB32};
  std::unique_ptr<QPainter> painter;
  vtkNew<PainterDevice> device;
  vtkNew<vtkContext2D> context;
};

TEST_F(PainterDeviceTest, a_line_is_of_the_pens_colour_and_breaks_where_there_is_no_place) {
  const auto none = std::numeric_limits<float>::quiet_NaN();
  float points[] = {10, 20.5F, 30, 20.5F, none, none, 50, 20.5F, 70, 20.5F};
  context->DrawPoly(points, 5);
  EXPECT_TRUE(is(Qt::red, 20, 20));
  EXPECT_TRUE(is(Qt::red, 60, 20));
  EXPECT_TRUE(is(Qt::white, 40, 20));
  EXPECT_NEAR(count(Qt::red), 40, 4);
}

TEST_F(PainterDeviceTest, an_area_is_filled_by_the_brush_and_cut_at_the_clip) {
  context->GetPen()->SetLineType(vtkPen::NO_PEN);
  float strip[] = {10, 10, 10, 30, 50, 10, 50, 30};
  context->DrawQuadStrip(strip, 4);
  EXPECT_EQ(count(Qt::blue), 40 * 20);
  EXPECT_TRUE(is(Qt::blue, 12, 12));
  int box[] = {60, 0, 10, 80};
  device->SetClipping(box);
  device->EnableClipping(true);
  float quad[] = {55, 40, 90, 40, 90, 60, 55, 60};
  context->DrawQuad(quad);
  device->EnableClipping(false);
  EXPECT_EQ(count(Qt::blue), 40 * 20 + 10 * 20);
  EXPECT_TRUE(is(Qt::blue, 65, 50));
}

TEST_F(PainterDeviceTest, places_go_through_all_transforms_that_are_pushed) {
  context->GetPen()->SetLineType(vtkPen::NO_PEN);
  vtkNew<vtkTransform2D> twice, aside;
  twice->Scale(2, 2);
  aside->Translate(20, 10);
  context->SetTransform(aside);
  context->PushMatrix();
  context->AppendTransform(twice);  // scaled first, then moved
  float quad[] = {0, 0, 5, 0, 5, 5, 0, 5};
  context->DrawQuad(quad);
  EXPECT_EQ(inked(), QRect(20, 80 - 20, 10, 10));
  context->PopMatrix();
  context->DrawQuad(quad);
  EXPECT_EQ(count(Qt::blue), 100) << "within the first";
}

TEST_F(PainterDeviceTest, an_images_first_row_is_the_lowest_and_its_cells_have_hard_edges) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const unsigned char rgba[16] = {255, 0, 0, 255, 0, 0, 255, 255, 0, 255, 0, 255, 0, 0, 0, 255};
  std::copy(rgba, rgba + 16, static_cast<unsigned char*>(image->GetScalarPointer()));
  context->DrawImage(vtkRectf(10, 20, 40, 20), image);
  EXPECT_TRUE(is(Qt::red, 11, 21));
  EXPECT_TRUE(is(Qt::blue, 48, 28));
  EXPECT_TRUE(is(QColor(0, 255, 0), 28, 38));
  EXPECT_EQ(count(Qt::black), 200);
  EXPECT_EQ(count(Qt::red), 200);
}

TEST_F(PainterDeviceTest, a_text_lies_as_it_is_justified_and_has_the_size_that_is_told) {
  context->GetTextProp()->SetFontSize(12);
  context->GetTextProp()->SetColor(0, 0, 0);
  context->GetTextProp()->SetJustificationToRight();
  context->GetTextProp()->SetVerticalJustificationToBottom();
  float bounds[4];
  context->ComputeStringBounds("0.25", bounds);
  context->DrawString(60, 30, "0.25");
  const QRect ink = inked();
  EXPECT_GT(ink.width(), 10);
  EXPECT_LE(ink.width(), bounds[2]);
  EXPECT_LE(ink.height(), bounds[3]);
  EXPECT_LE(ink.right(), 60);
  EXPECT_GE(ink.right(), 56);
  EXPECT_LE(ink.bottom(), 79 - 30);
  context->GetTextProp()->SetOrientation(90);
  float turned[4];
  context->ComputeStringBounds("0.25", turned);
  EXPECT_NEAR(turned[2], bounds[3], 1e-3);
  EXPECT_NEAR(turned[3], bounds[2], 1e-3);
}

TEST_F(PainterDeviceTest, a_mark_is_as_wide_as_the_pen) {
  context->GetPen()->SetWidth(10);
  float at[] = {30, 40};
  for (const int shape : {VTK_MARKER_CIRCLE, VTK_MARKER_SQUARE, VTK_MARKER_DIAMOND}) {
    painter->fillRect(sheet.rect(), Qt::white);
    context->DrawMarkers(shape, false, at, 1);
    EXPECT_TRUE(is(Qt::red, 30, 40)) << shape;
    EXPECT_NEAR(inked().width(), 10, 1) << shape;
    EXPECT_NEAR(inked().center().x(), 30, 1) << shape;
    EXPECT_NEAR(inked().center().y(), 79 - 40, 1) << shape;
  }
}

}  // namespace
}  // namespace sonde::ui::test
