// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/chart_canvas.hpp"

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <QImage>
#include <QPalette>

#include "ui/base/theme.hpp"

namespace sonde::ui {

struct ChartCanvas::Drawing {
  explicit Drawing(ChartCanvas& owner) : widget(new QVTKOpenGLNativeWidget(&owner)) {}

  QVTKOpenGLNativeWidget* widget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkContextActor> actor;
};

ChartCanvas::ChartCanvas(QWidget* parent)
    : QWidget(parent), drawing_(std::make_unique<Drawing>(*this)) {
  Drawing& d = *drawing_;
  d.widget->setAttribute(Qt::WA_TransparentForMouseEvents);
  d.widget->setFocusPolicy(Qt::NoFocus);
  d.widget->setAcceptDrops(false);
  d.window->SetMultiSamples(0);
  d.widget->setRenderWindow(d.window);
  d.widget->interactor()->SetInteractorStyle(nullptr);
  d.window->AddRenderer(d.renderer);
  d.renderer->AddActor(d.actor);
  d.actor->GetScene()->SetRenderer(d.renderer);
}

ChartCanvas::~ChartCanvas() = default;

QImage ChartCanvas::picture() const { return drawing_->widget->grabFramebuffer(); }

vtkContextScene& ChartCanvas::scene() const { return *drawing_->actor->GetScene(); }

void ChartCanvas::redraw() {
  if (!isVisible()) return;
  const QColor back = plot_background(palette());
  drawing_->renderer->SetBackground(back.redF(), back.greenF(), back.blueF());
  arrange(devicePixelRatioF());
  drawing_->window->Render();
}

void ChartCanvas::place_chart(vtkChartXY& chart, const QRectF& within, double ratio) const {
  chart.SetSize(vtkRectf(float(within.left() * ratio), float((height() - within.bottom()) * ratio),
                         float(within.width() * ratio), float(within.height() * ratio)));
}

void ChartCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  drawing_->widget->setGeometry(rect());
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
