// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QApplication;
class QPalette;
class QString;

namespace sonde::ui {

/// The colours of the picture: one meaning each, the same in view, legend and panels. Those of the
/// overlays can be told apart in each of the three ways of seeing fewer hues, and read on dark.
namespace colour {
inline const QColor probe{233, 125, 37};
inline const QColor fixed{129, 135, 159};
inline const QColor ghost{73, 219, 255};            ///< the separated probe and the motion to it
inline const QColor ghost_on_probe{184, 176, 124};  ///< the probe through it, as it is lit
inline const QColor contact{247, 236, 84};
inline const QColor force{255, 26, 85};
inline const QColor torque{200, 110, 255};
inline const QColor nearest{20, 165, 112};    ///< the nearest way out, searched for
inline const QColor straight{226, 250, 250};  ///< the way out without a turn, PD_t
inline const QColor turn{168, 140, 255};      ///< what a turn adds to the depth
inline const QColor hole{255, 235, 160};      ///< where a mesh is not closed
inline const QColor flipped{230, 90, 200};    ///< where its faces do not agree which side is out
inline const QColor cap{153, 238, 119};       ///< what closes openings of a mesh, and was not in it
inline const QColor crossing{255, 120, 150};  ///< triangles that go through others of their mesh
inline const QColor cut{120, 190, 255};       ///< the plane that bodies are cut at
inline const QColor bound{170, 160, 255};     ///< what shows the lower bound
inline const QColor measure{255, 255, 255};   ///< what was measured
inline const QColor clearance{255, 255, 255};  ///< the room between the bodies, measured too
inline const QColor stiffness{255, 170, 120};  ///< what the hand feels as stiff
inline const QColor chosen{255, 255, 255};     ///< the contact that is marked
inline const QColor ready{140, 220, 130};
inline const QColor text{222, 228, 235};
inline const QColor faint{150, 160, 172};
inline const QColor background_top{46, 53, 62};
inline const QColor background_bottom{22, 26, 31};
inline const QColor light_background_top{250, 251, 252};
inline const QColor light_background_bottom{226, 230, 236};
}  // namespace colour

/// Are the windows of this palette light?
bool is_light(const QPalette& palette);

/// Behind curves: dark, or light where the windows are.
QColor plot_background(const QPalette& palette);

/// Text that stands back, on a window of this palette, light or dark.
QColor faint_text(const QPalette& palette);

/// The colour, or a darker one of its hue that can be read on a light window of this palette; black
/// for white, which stands out most on a dark one.
QColor readable(const QColor& colour, const QPalette& palette);

/// Text in a colour of the picture, to be read on the program's windows: rich text. A QLabel that
/// shows it follows the theme.
QString in_colour(const QColor& colour, const QString& text);

enum class Theme { dark, light, system };

/// Is what the system had for windows, before any theme was applied, dark?
bool system_is_dark();

/// A palette on Qt's Fusion style, dark or light; also while windows are open. View and plots
/// follow it: their colours are made for a dark background, and darkened for a light one.
void apply_theme(QApplication& application, Theme theme = Theme::dark);

/// The theme that was chosen, kept between runs.
Theme chosen_theme();
void choose_theme(QApplication& application, Theme theme);

}  // namespace sonde::ui
