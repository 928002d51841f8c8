// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace sonde::ui {

/// With the keyboard on it, Space and Enter press it, whatever else they do in the window.
class KeyButton : public QToolButton {
 public:
  using QToolButton::QToolButton;

 protected:
  bool event(QEvent* event) override;
};

}  // namespace sonde::ui
