// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <vector>

#include "ui/views/viewport.hpp"

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace sonde::ui {

/// A part of a recording, and how finely it is wanted.
struct Span {
  double from = 0, to = 0;  ///< s
  double rate = 25;         ///< pictures or steps for each second of it
  /// With the first and the last.
  std::vector<double> times() const;
};

/// What a picture, or each picture of an animation, is to be like.
struct PictureWanted {
  PictureOptions options;
  int frames = 25;    ///< of an animation
  bool film = false;  ///< beside the pictures
  Span span;          ///< of a recording
};

/// Asks for that, or for what of it is wanted.
class ExportDialog : public QDialog {
 public:
  enum class Of { picture, animation, recording, recording_steps };
  /// `all`: the whole of the recording.
  ExportDialog(Of of, const QSize& size, const Span& all, QWidget* parent);
  PictureWanted wanted() const;

 private:
  void add_picture(Of of, QFormLayout& form, const QSize& size);
  void add_span(QFormLayout& form, const Span& all);
  Span span() const;

  QSpinBox *width_, *height_, *frames_;
  QDoubleSpinBox *from_, *to_, *rate_;
  QLabel* count_;
  QCheckBox *transparent_, *overlays_, *film_;
};

}  // namespace sonde::ui
