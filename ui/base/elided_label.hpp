// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>

namespace sonde::ui {

/// One line of text that uses the available room. Text that does not fit ends in "…"; text() and
/// the tooltip are the whole text.
class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void show_text(const QString& text);
  /// The part that fits.
  QString shown() const;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace sonde::ui
