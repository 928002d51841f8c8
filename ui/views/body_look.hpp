// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "ui/views/seeing.hpp"

class vtkActor;
class vtkPlane;

namespace sonde::ui {

/// The flat colour in which the inside of a body of that colour shows at a cut.
QColor cut_colour(const QColor& colour);

/// Draws a body in that look. Where a plane is given (the half that its normal points to is drawn),
/// the body is cut there by its mapper, which costs nothing in triangles; the inside that shows is
/// drawn flat, in a darker colour, as if the cut were filled.
void apply_look(vtkActor& actor, Look look, const QColor& colour, bool solid, vtkPlane* cut);

}  // namespace sonde::ui
