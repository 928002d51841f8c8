// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/button_style.hpp"

#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

const QColor under_cursor{47, 168, 216};    // as marks that are on
constexpr int hovered = 70, pressed = 130;  // alpha of 255
constexpr double round = 2.5;               // pixels

/// Its shade over the button; none at rest.
int shade_of(const QStyleOption& option) {
  if (!(option.state & QStyle::State_Enabled)) return 0;
  if (option.state & QStyle::State_Sunken) return pressed;
  return option.state & QStyle::State_MouseOver ? hovered : 0;
}

}  // namespace

ButtonStyle::ButtonStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void ButtonStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                                QPainter* painter, const QWidget* widget) const {
  QProxyStyle::drawPrimitive(element, option, painter, widget);
  const bool button = element == PE_PanelButtonCommand || element == PE_PanelButtonTool;
  const int shade = button ? shade_of(*option) : 0;
  if (shade == 0) return;
  QColor colour = under_cursor;
  colour.setAlpha(shade);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(Qt::NoPen);
  painter->setBrush(colour);
  painter->drawRoundedRect(QRectF(option->rect).adjusted(1, 1, -1, -1), round, round);
  painter->restore();
}

}  // namespace sonde::ui
