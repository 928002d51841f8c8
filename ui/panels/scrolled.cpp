// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/scrolled.hpp"

#include <QDockWidget>
#include <QScrollArea>
#include <QVBoxLayout>

namespace sonde::ui {

Scrolled scrolled(QDockWidget& dock) {
  auto* scroll = new QScrollArea(&dock);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setMinimumWidth(160);  // on a small screen the view comes first
  auto* content = new QWidget(scroll);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(6, 8, 6, 8);
  scroll->setWidget(content);
  dock.setWidget(scroll);
  return {scroll, content, layout};
}

}  // namespace sonde::ui
