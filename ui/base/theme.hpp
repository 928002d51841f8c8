// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QApplication;
class QPalette;

namespace sonde::ui {

/// The colours of the picture: one meaning each, the same in view, legend and panels.
namespace colour {
inline const QColor probe{242, 160, 61};
inline const QColor fixed{134, 153, 173};
inline const QColor ghost{87, 211, 255};  ///< the separated probe and the motion to it
inline const QColor contact{255, 225, 77};
inline const QColor force{255, 92, 84};
inline const QColor torque{255, 128, 200};
inline const QColor nearest{140, 220, 130};   ///< the nearest way out, searched for
inline const QColor straight{235, 235, 225};  ///< the way out without a turn, PD_t
inline const QColor turn{168, 140, 255};      ///< what a turn adds to the depth
inline const QColor hole{255, 235, 160};      ///< where a mesh is not closed
inline const QColor flipped{230, 90, 200};    ///< where its faces do not agree which side is out
inline const QColor cut{120, 190, 255};       ///< the plane that bodies are cut at
inline const QColor measure{255, 255, 255};   ///< what was measured
inline const QColor chosen{255, 255, 255};    ///< the contact that is marked
inline const QColor ready{140, 220, 130};
inline const QColor text{222, 228, 235};
inline const QColor faint{150, 160, 172};
inline const QColor background_top{46, 53, 62};
inline const QColor background_bottom{22, 26, 31};
}  // namespace colour

/// Text that stands back, on a window of this palette, light or dark.
QColor faint_text(const QPalette& palette);

/// A dark palette on Qt's Fusion style.
void apply_theme(QApplication& application);

}  // namespace sonde::ui
