// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>

namespace sonde::ui {

/// The body's colour, as in the legend.
class BodyMark : public QWidget {
 public:
  BodyMark(const QColor& colour, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QColor colour_;
};

}  // namespace sonde::ui
