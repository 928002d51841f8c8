// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace sonde::ui {

/// One line that takes whatever room there is: where that is too little, it ends in "…". text() is
/// all of it, and so is the tooltip.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void show_text(const QString& text);
  /// What there is room for.
  QString shown() const;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace sonde::ui
