// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "ui/views/viewport.hpp"

class QCheckBox;
class QSpinBox;

namespace sonde::ui {

/// What a picture, or each picture of an animation, is to be like.
struct PictureWanted {
  PictureOptions options;
  int frames = 25;    ///< of an animation
  bool film = false;  ///< beside the pictures
};

/// Asks for that.
class ExportDialog : public QDialog {
 public:
  enum class Of { picture, animation };
  ExportDialog(Of of, const QSize& size, QWidget* parent);
  PictureWanted wanted() const;

 private:
  QSpinBox *width_, *height_, *frames_;
  QCheckBox *transparent_, *overlays_, *film_;
};

}  // namespace sonde::ui
