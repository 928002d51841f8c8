// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/theme.hpp"

#include <QApplication>
#include <QLabel>
#include <QPalette>
#include <QRegularExpression>
#include <QSettings>
#include <QString>
#include <algorithm>
#include <cmath>

#include "ui/base/button_style.hpp"

namespace sonde::ui {

QColor faint_text(const QPalette& palette) {
  constexpr double share = 0.65;
  const QColor& text = palette.color(QPalette::WindowText);
  const QColor& window = palette.color(QPalette::Window);
  const auto mixed = [](double one, double other) { return share * one + (1 - share) * other; };
  return QColor::fromRgbF(mixed(text.redF(), window.redF()), mixed(text.greenF(), window.greenF()),
                          mixed(text.blueF(), window.blueF()));
}

namespace {

constexpr double least_contrast =
    4.5;  // of small text, by the Web Content Accessibility Guidelines

struct Tones {
  QColor window, base, button, text, dim, title, line, group;
};
const Tones dark{{36, 41, 48},    {26, 30, 36}, {50, 57, 66}, colour::text,
                 {140, 148, 158}, {44, 50, 58}, {69, 78, 89}, {150, 160, 172}};
const Tones light{{240, 242, 245}, {255, 255, 255}, {226, 230, 236}, {27, 32, 39},
                  {95, 102, 112},  {222, 227, 233}, {190, 197, 206}, {84, 93, 105}};

QPalette palette_of(const Tones& tones) {
  QPalette palette;
  palette.setColor(QPalette::Window, tones.window);
  palette.setColor(QPalette::WindowText, tones.text);
  palette.setColor(QPalette::Base, tones.base);
  palette.setColor(QPalette::AlternateBase, tones.window);
  palette.setColor(QPalette::ToolTipBase, tones.button);
  palette.setColor(QPalette::ToolTipText, tones.text);
  palette.setColor(QPalette::Text, tones.text);
  palette.setColor(QPalette::Button, tones.button);
  palette.setColor(QPalette::ButtonText, tones.text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Highlight, QColor(38, 128, 170));
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::Link, readable(colour::ghost, palette));
  palette.setColor(QPalette::PlaceholderText, tones.dim);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, tones.dim);
  return palette;
}

QString style_of(const Tones& tones) {
  return QStringLiteral(
             "QToolTip { color: %1; background: %2; border: 1px solid %3; padding: 3px; }"
             "QDockWidget { font-weight: 600; }"
             "QDockWidget::title { background: %4; padding: 5px 8px; }"
             "QRadioButton::indicator { width: 11px; height: 11px; border-radius: 6px;"
             "  border: 1px solid #8793a1; background: %5; }"
             "QRadioButton::indicator:checked { background: #2fa8d8; border: 3px solid %5; }"
             "QStatusBar::item { border: none; }"
             "QGroupBox { border: none; border-top: 1px solid %3; margin-top: 16px;"
             "  padding-top: 4px; font-weight: 600; }"
             "QGroupBox::title { subcontrol-origin: margin; left: 0px; padding-right: 6px;"
             "  color: %6; }")
      .arg(tones.text.name(), tones.button.name(), tones.line.name(), tones.title.name(),
           tones.base.name(), tones.group.name());
}

double luminance(const QColor& colour) {
  const auto linear = [](double x) {
    return x <= 0.03928 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

QString span_of(const QColor& colour) {
  return QStringLiteral("<span class='%1' style='color:%2'>")
      .arg(colour.name(), readable(colour, QApplication::palette()).name());
}

/// What in_colour() has made, for the theme that is on now.
QString tinted_again(const QString& text) {
  static const QRegularExpression spans(
      QStringLiteral("<span class='(#[0-9a-f]{6})' style='color:#[0-9a-f]{6}'>"));
  QString out;
  int done = 0;
  for (auto all = spans.globalMatch(text); all.hasNext();) {
    const QRegularExpressionMatch span = all.next();
    out += text.mid(done, span.capturedStart() - done) + span_of(QColor(span.captured(1)));
    done = span.capturedEnd();
  }
  return out + text.mid(done);
}

const QString theme_key = QStringLiteral("theme");

}  // namespace

bool is_light(const QPalette& palette) {
  constexpr double half_way = 0.4;
  return luminance(palette.color(QPalette::Window)) >= half_way;
}

QColor plot_background(const QPalette& palette) {
  return is_light(palette) ? palette.color(QPalette::Base) : colour::background_bottom;
}

QColor readable(const QColor& colour, const QPalette& palette) {
  const double window = luminance(palette.color(QPalette::Window));
  if (!is_light(palette)) return colour;
  QColor darker = colour == QColor(Qt::white) ? QColor(Qt::black) : colour;
  while (darker.value() > 0 && (window + 0.05) / (luminance(darker) + 0.05) < least_contrast)
    darker.setHsv(darker.hsvHue(), darker.hsvSaturation(), std::max(darker.value() - 4, 0));
  return darker;
}

QString in_colour(const QColor& colour, const QString& text) {
  return span_of(colour) + text + QStringLiteral("</span>");
}

bool system_is_dark() {
  static const bool is_dark = luminance(QApplication::palette().color(QPalette::Window)) < 0.2;
  return is_dark;
}

void apply_theme(QApplication& application, Theme theme) {
  const bool is_dark = theme == Theme::system ? system_is_dark() : theme == Theme::dark;
  system_is_dark();  // asked while the palette is still the system's
  QApplication::setStyle(new ButtonStyle);
  QApplication::setPalette(palette_of(is_dark ? dark : light));
  application.setStyleSheet(style_of(is_dark ? dark : light));
  for (QWidget* widget : QApplication::allWidgets())
    if (auto* label = qobject_cast<QLabel*>(widget)) {
      const QString again = tinted_again(label->text());
      if (again != label->text()) label->setText(again);
    }
}

Theme chosen_theme() {
  const int kept = QSettings().value(theme_key, static_cast<int>(Theme::dark)).toInt();
  return static_cast<Theme>(std::clamp(kept, 0, static_cast<int>(Theme::system)));
}

void choose_theme(QApplication& application, Theme theme) {
  QSettings().setValue(theme_key, static_cast<int>(theme));
  apply_theme(application, theme);
}

}  // namespace sonde::ui
