// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/tone.hpp"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QColor>
#include <QPalette>

namespace sonde::ui {
namespace {

TEST(Tone, lines_are_darker_on_a_light_window_and_themselves_again_on_a_dark_one) {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkActor> line, body;
  for (vtkActor* actor : {line.Get(), body.Get()}) {
    actor->GetProperty()->SetColor(1, 0.8, 0.2);
    renderer->AddActor(actor);
  }
  const auto colour = [](vtkActor& actor) {
    double rgb[3];
    actor.GetProperty()->GetColor(rgb);
    return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
  };
  const QColor own = colour(*line);
  const QPalette dark(QColor(50, 57, 66), QColor(36, 41, 48));
  const QPalette light(QColor(230, 230, 230), QColor(245, 245, 245));
  Tone tone;
  tone.apply(*renderer, light, {body.Get()});
  EXPECT_LT(colour(*line).value(), own.value());
  EXPECT_NEAR(colour(*line).hue(), own.hue(), 2);
  EXPECT_EQ(colour(*body), own) << "it was left out";
  tone.apply(*renderer, light, {body.Get()});  // not darker still
  const QColor once = colour(*line);
  tone.apply(*renderer, light, {body.Get()});
  EXPECT_EQ(colour(*line), once);
  tone.apply(*renderer, dark);
  EXPECT_EQ(colour(*line), own);
}

}  // namespace
}  // namespace sonde::ui
