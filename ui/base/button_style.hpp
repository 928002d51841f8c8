// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace sonde::ui {

/// Qt's Fusion, where a button under the cursor and one that is pressed are seen to be so: Fusion's
/// own shades differ by a few per cent, which nobody sees on a dark window.
class ButtonStyle : public QProxyStyle {
 public:
  ButtonStyle();
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};

}  // namespace sonde::ui
