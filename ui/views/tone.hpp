// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkProperty.h>
#include <vtkSmartPointer.h>

#include <QColor>
#include <map>
#include <vector>

class QPalette;
class vtkActor;
class vtkRenderer;

namespace sonde::ui {

/// Makes lines and glyphs, whose colours are chosen for a dark background, readable on a light one:
/// darker, of the same hue. Their own colours come back on a dark one.
class Tone {
 public:
  /// All actors of that renderer but those.
  void apply(vtkRenderer& renderer, const QPalette& palette,
             const std::vector<const vtkActor*>& but = {});

 private:
  std::map<vtkSmartPointer<vtkProperty>, QColor> own_;
};

}  // namespace sonde::ui
