// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/theme.hpp"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace sonde::ui {

QColor faint_text(const QPalette& palette) {
  constexpr double share = 0.65;
  const QColor& text = palette.color(QPalette::WindowText);
  const QColor& window = palette.color(QPalette::Window);
  const auto mixed = [](double one, double other) { return share * one + (1 - share) * other; };
  return QColor::fromRgbF(mixed(text.redF(), window.redF()), mixed(text.greenF(), window.greenF()),
                          mixed(text.blueF(), window.blueF()));
}

void apply_theme(QApplication& application) {
  QApplication::setStyle(QStyleFactory::create("Fusion"));
  const QColor window(36, 41, 48);
  const QColor base(26, 30, 36);
  const QColor button(50, 57, 66);
  const QColor dim(120, 128, 138);
  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, colour::text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::ToolTipBase, button);
  palette.setColor(QPalette::ToolTipText, colour::text);
  palette.setColor(QPalette::Text, colour::text);
  palette.setColor(QPalette::Button, button);
  palette.setColor(QPalette::ButtonText, colour::text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Highlight, QColor(38, 128, 170));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, colour::ghost);
  palette.setColor(QPalette::PlaceholderText, dim);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, dim);
  QApplication::setPalette(palette);
  application.setStyleSheet(
      "QToolTip { color: #dee4eb; background: #323942; border: 1px solid #566270; padding: 3px; }"
      "QDockWidget { font-weight: 600; }"
      "QDockWidget::title { background: #2c323a; padding: 5px 8px; }"
      "QRadioButton::indicator { width: 11px; height: 11px; border-radius: 6px;"
      "  border: 1px solid #8793a1; background: #1a1e24; }"
      "QRadioButton::indicator:checked { background: #57d3ff; border: 3px solid #1a1e24; }"
      "QStatusBar::item { border: none; }"
      "QGroupBox { border: none; border-top: 1px solid #454e59; margin-top: 16px;"
      "  padding-top: 4px; font-weight: 600; }"
      "QGroupBox::title { subcontrol-origin: margin; left: 0px; padding-right: 6px;"
      "  color: #96a0ac; }");
}

}  // namespace sonde::ui
