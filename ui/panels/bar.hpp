// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QWidget>
#include <vector>

namespace sonde::ui {

/// A thin bar, filled from the left by coloured parts of the whole.
class Bar : public QWidget {
 public:
  explicit Bar(QWidget* parent);
  struct Part {
    double fraction;
    QColor colour;
  };
  void set(std::vector<Part> parts);
  QSize sizeHint() const override { return {120, 8}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Part> parts_;
};

}  // namespace sonde::ui
