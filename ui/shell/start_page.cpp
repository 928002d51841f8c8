// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/start_page.hpp"

#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/format.hpp"
#include "ui/base/resources.hpp"
#include "ui/document/recent_files.hpp"

namespace sonde::ui {
namespace {

constexpr QSize picture_size{132, 88};
constexpr int room = 16;             // pixels, at the sides
constexpr int between_tiles = 6;     // pixels
constexpr double for_gallery = 0.7;  // of the width: what is left is for the files opened last
const QString ending = QStringLiteral(".sonde.json");

QLabel* heading(const QString& text, QWidget* parent, double larger) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * larger);
  font.setBold(true);
  label->setFont(font);
  return label;
}

void clear(QVBoxLayout& layout) {
  while (QLayoutItem* item = layout.takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent), recent_(new QVBoxLayout) {
  setObjectName(QStringLiteral("start_page"));
  parent->installEventFilter(this);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* content = new QWidget(scroll);
  scroll->setWidget(content);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(scroll);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(room, room, room, room);
  layout->setSpacing(10);
  complaint_ = build_complaint();
  layout->addWidget(complaint_);
  layout->addWidget(heading(QStringLiteral("Feel how two bodies touch"), content, 1.6));
  auto* buttons = new QHBoxLayout;
  const auto add = [&](const char* text, const char* object, void (StartPage::*wanted)()) {
    auto* button = new QPushButton(QString::fromUtf8(text), content);
    button->setObjectName(QLatin1String(object));
    connect(button, &QPushButton::clicked, this, wanted);
    buttons->addWidget(button);
  };
  add("Open two meshes…", "start_meshes", &StartPage::meshes_wanted);
  add("Open a scene…", "start_scene", &StartPage::scene_wanted);
  buttons->addStretch();
  layout->addLayout(buttons);
  layout->addWidget(
      new QLabel(QStringLiteral("or drop a scene, one mesh or two meshes here"), content));
  auto* lists = new QHBoxLayout;
  lists->setSpacing(2 * room);
  auto* scenes = new QVBoxLayout;
  scenes->setSpacing(layout->spacing());
  scenes->addWidget(heading(QStringLiteral("Scenes to try"), content, 1.15));
  scenes->addWidget(gallery());
  scenes->addStretch();
  lists->addLayout(scenes);
  auto* files = new QVBoxLayout;
  files->setSpacing(layout->spacing());
  files->addWidget(heading(QStringLiteral("Opened last"), content, 1.15));
  files->addLayout(recent_);
  files->addStretch();
  lists->addLayout(files);
  lists->addStretch(1);
  layout->addLayout(lists);
  layout->addStretch();
}

QFrame* StartPage::build_complaint() {
  auto* frame = new QFrame(this);
  frame->setObjectName(QStringLiteral("start_complaint"));
  frame->setFrameShape(QFrame::StyledPanel);
  auto* row = new QHBoxLayout(frame);
  reason_ = new QLabel(frame);
  reason_->setObjectName(QStringLiteral("start_reason"));
  reason_->setWordWrap(true);
  reason_->setTextFormat(Qt::PlainText);  // file names
  reason_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  row->addWidget(reason_, 1);
  auto* locate = new QPushButton(QStringLiteral("Locate…"), frame);
  locate->setObjectName(QStringLiteral("start_locate"));
  connect(locate, &QPushButton::clicked, this, [this] {
    if (const auto wanted = locate_) wanted();
  });
  row->addWidget(locate);
  frame->hide();
  return frame;
}

void StartPage::complain(const QString& reason, std::function<void()> locate) {
  reason_->setText(QStringLiteral("Nothing was opened. %1").arg(reason));
  locate_ = std::move(locate);
  complaint_->show();
}

QWidget* StartPage::gallery() {
  auto* box = new QWidget(this);
  const QDir folder(resource(QStringLiteral("scenes")));
  for (const QString& file : folder.entryList({'*' + ending}, QDir::Files, QDir::Name)) {
    const QString name = file.chopped(ending.size());
    auto* button = new QToolButton(box);
    button->setObjectName(QStringLiteral("gallery_") + name);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIcon(QIcon(folder.filePath(name + QStringLiteral(".png"))));
    button->setIconSize(picture_size);
    button->setText(QString(name).replace('-', ' '));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    const QString path = folder.filePath(file);
    connect(button, &QToolButton::clicked, this, [this, path] { emit chosen({path}); });
    tiles_.push_back(button);
  }
  return box;
}

/// In rows of one length, and as few as find room beside the files that were opened last.
void StartPage::lay_tiles() {
  if (tiles_.empty()) return;
  const int count = static_cast<int>(tiles_.size());
  int each = 0;
  for (const QToolButton* tile : tiles_) each = std::max(each, tile->sizeHint().width());
  each += between_tiles;
  const int fit = std::clamp(static_cast<int>(for_gallery * width()) / each, 1, count);
  const int rows = (count + fit - 1) / fit, columns = (count + rows - 1) / rows;
  if (columns == columns_) return;
  columns_ = columns;
  QWidget& box = *tiles_.front()->parentWidget();
  delete box.layout();  // rows that it once had would keep their room
  auto* grid = new QGridLayout(&box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(between_tiles);
  for (int i = 0; i < count; ++i)
    grid->addWidget(tiles_[static_cast<std::size_t>(i)], i / columns, i % columns);
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  lay_tiles();
}

void StartPage::show_recent() {
  clear(*recent_);
  const auto all = recent_files();
  if (all.empty()) recent_->addWidget(new QLabel(QStringLiteral("Nothing yet."), this));
  for (const QStringList& files : all) {
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("recent_file"));
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setText(recent_name(files).replace('&', QStringLiteral("&&")));
    button->setToolTip(tooltip_of(files.join('\n')));
    connect(button, &QToolButton::clicked, this, [this, files] { emit chosen(files); });
    recent_->addWidget(button);
  }
}

void StartPage::present() {
  complaint_->hide();
  show_recent();
  setGeometry(parentWidget()->rect());
  lay_tiles();
  show();
  raise();
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

/// Nothing of the picture below shines through.
void StartPage::paintEvent(QPaintEvent* /*event*/) {
  QPainter(this).fillRect(rect(), palette().color(QPalette::Window));
}

}  // namespace sonde::ui
