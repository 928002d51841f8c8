// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/side_bar.hpp"

#include <QAction>
#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionToolButton>
#include <QStylePainter>
#include <QToolButton>
#include <algorithm>

namespace sonde::ui {
namespace {

constexpr int usual_width = 300;  // pixels: what comes to be in a dock later has room too

/// A button whose text runs along the strip.
class Tab : public QToolButton {
 public:
  Tab(bool upwards, QWidget* parent) : QToolButton(parent), upwards_(upwards) {}
  QSize sizeHint() const override { return QToolButton::sizeHint().transposed(); }
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QStyleOptionToolButton option;
    initStyleOption(&option);
    option.rect = QRect(0, 0, height(), width());
    QStylePainter painter(this);
    if (upwards_) {
      painter.translate(0, height());
      painter.rotate(-90);
    } else {
      painter.translate(width(), 0);
      painter.rotate(90);
    }
    painter.drawComplexControl(QStyle::CC_ToolButton, option);
  }

 private:
  bool upwards_;
};

/// What is in a dock, with a bar to scroll it, is not cut off at its right.
int width_of(const QDockWidget& dock) {
  const auto* scroll = qobject_cast<const QScrollArea*>(dock.widget());
  if (!scroll || !scroll->widget()) return 0;
  return scroll->widget()->minimumSizeHint().width() +
         scroll->verticalScrollBar()->sizeHint().width();
}

bool is_beside(Qt::DockWidgetArea area) {
  return area == Qt::LeftDockWidgetArea || area == Qt::RightDockWidgetArea;
}

/// The docks that are open at either side of the view.
std::vector<QDockWidget*> open_beside(const QMainWindow& window) {
  std::vector<QDockWidget*> open;
  for (QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
    if (dock->isVisible() && !dock->isFloating() && is_beside(window.dockWidgetArea(dock)))
      open.push_back(dock);
  return open;
}

}  // namespace

SideBar::SideBar(Qt::ToolBarArea side, const QString& title, const char* object, QWidget* window)
    : QToolBar(title, window), reads_upwards_(side == Qt::LeftToolBarArea) {
  setObjectName(QLatin1String(object));
  setMovable(false);
  setFloatable(false);
  layout()->setContentsMargins(2, 4, 2, 4);
  layout()->setSpacing(2);
  setContextMenuPolicy(Qt::PreventContextMenu);  // it stays: without it no dock is found
}

void SideBar::add(QDockWidget& dock) {
  auto* tab = new Tab(reads_upwards_, this);
  tab->setObjectName(QStringLiteral("tab_") + dock.objectName());
  tab->setText(dock.windowTitle());
  tab->setCheckable(true);
  tab->setChecked(!dock.isHidden());
  tab->setFocusPolicy(Qt::NoFocus);  // the keyboard stays where it is
  connect(tab, &QToolButton::clicked, &dock, [&dock](bool on) { dock.setVisible(on); });
  connect(dock.toggleViewAction(), &QAction::toggled, tab, &QToolButton::setChecked);
  connect(dock.toggleViewAction(), &QAction::toggled, this, [this, &dock](bool open) {
    if (open)
      on_opened(dock);
    else if (const auto* in = qobject_cast<QMainWindow*>(parentWidget());
             in && is_beside(in->dockWidgetArea(&dock)) && !dock.isFloating() && dock.width() > 1)
      width_ = dock.width();  // one below the view is as wide as that
  });
  addWidget(tab);
  docks_.push_back(&dock);
}

void SideBar::add_space() {
  auto* space = new QWidget(this);
  space->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Expanding);
  addWidget(space);
}

void SideBar::note_widths() {
  const auto* window = qobject_cast<const QMainWindow*>(parentWidget());
  noted_.clear();
  if (!window) return;
  for (const QDockWidget* dock : open_beside(*window)) noted_[dock] = dock->width();
}

/// In place of the one that was open, and as wide.
void SideBar::on_opened(QDockWidget& opened) {
  auto* window = qobject_cast<QMainWindow*>(parentWidget());
  if (!window || opened.isFloating()) return;
  const auto area = window->dockWidgetArea(&opened);
  for (QDockWidget* other : docks_)
    if (other != &opened && !other->isFloating() && !other->isHidden() &&
        window->dockWidgetArea(other) == area)
      other->hide();
  if (!is_beside(area) || held_) return;
  // What is open at the other side keeps its width.
  QList<QDockWidget*> docks{&opened};
  QList<int> widths{std::max({width_, width_of(opened), usual_width})};
  for (QDockWidget* other : open_beside(*window)) {
    if (other == &opened) continue;
    const auto noted = noted_.find(other);
    docks << other;
    widths << (noted == noted_.end() ? other->width() : noted->second);
  }
  window->resizeDocks(docks, widths, Qt::Horizontal);
}

}  // namespace sonde::ui
