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
  /// Ends after a whole item of a list, as long as one fits: a number that is cut reads as another.
  void end_after_items(const QString& separator) { separator_ = separator; }
  /// The part that fits.
  QString shown() const;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString separator_;
};

}  // namespace sonde::ui
