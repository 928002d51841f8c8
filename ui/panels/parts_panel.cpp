// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/parts_panel.hpp"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/views/part_surface.hpp"

namespace sonde::ui {
namespace {

enum PartColumn { part_name_at, part_shown_at, part_felt_at, part_triangles_at };

QIcon patch(const QColor& colour) {
  QPixmap pixels(14, 14);
  pixels.fill(colour);
  return {pixels};
}

Qt::CheckState tick(bool on) { return on ? Qt::Checked : Qt::Unchecked; }

}  // namespace

PartsPanel::PartsPanel(QWidget* parent)
    : QDockWidget(QStringLiteral("Parts"), parent), rows_(new QTreeWidget(this)) {
  setObjectName(QStringLiteral("parts_panel"));
  rows_->setObjectName(QStringLiteral("part_rows"));
  rows_->setRootIsDecorated(false);
  rows_->setIndentation(0);
  rows_->setUniformRowHeights(true);
  rows_->setTextElideMode(Qt::ElideMiddle);  // exported names often differ at their ends
  rows_->setHeaderLabels({QStringLiteral("Part"), QStringLiteral("Shown"), QStringLiteral("Felt"),
                          QStringLiteral("Triangles")});
  rows_->headerItem()->setToolTip(
      part_name_at,
      QStringLiteral("By which contacts and reports name it. Double-click to rename it."));
  rows_->headerItem()->setToolTip(part_shown_at, QStringLiteral("Whether the view shows it"));
  rows_->headerItem()->setToolTip(
      part_felt_at,
      QStringLiteral("Whether it counts for contact, force and clearance. What does not "
                     "costs nothing."));
  rows_->header()->setStretchLastSection(false);
  rows_->header()->setMinimumSectionSize(40);
  for (const PartColumn column : {part_shown_at, part_felt_at, part_triangles_at})
    rows_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  rows_->header()->setSectionResizeMode(part_name_at, QHeaderView::Stretch);
  rows_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->addWidget(rows_);
  auto* note =
      new QLabel(QStringLiteral("A click on a part in the view chooses it here."), content);
  note->setWordWrap(true);
  layout->addWidget(note);
  auto* buttons = new QGridLayout;
  add_ = button(QStringLiteral("&Add part…"), "add_part",
                QStringLiteral("Further meshes, in the axes of the fixed body. Meshes can also be "
                               "dragged onto the window."));
  remove_ = button(QStringLiteral("Re&move"), "remove_part", QStringLiteral("The chosen part"));
  colour_ = button(QStringLiteral("&Colour…"), "part_colour", QStringLiteral("The chosen part's"));
  swap_ = button(QStringLiteral("&Swap"), "swap_parts",
                 QStringLiteral("What is the probe is the fixed body, and the other way round"));
  take_apart_ = button(QStringLiteral("&Take apart"), "take_apart",
                       QStringLiteral("Each component of the chosen part's mesh becomes a part: "
                                      "what hangs together, with its cavities"));
  buttons->addWidget(add_, 0, 0);
  buttons->addWidget(remove_, 0, 1);
  buttons->addWidget(colour_, 1, 0);
  buttons->addWidget(swap_, 1, 1);
  buttons->addWidget(take_apart_, 2, 0, 1, 2);
  layout->addLayout(buttons);
  setWidget(content);
  connect(rows_, &QTreeWidget::itemSelectionChanged, this, [this] {
    update_buttons();
    if (!filling_) emit chosen_changed(chosen());
  });
  connect(rows_, &QTreeWidget::itemChanged, this, &PartsPanel::on_changed);
  connect(add_, &QPushButton::clicked, this, &PartsPanel::add_wanted);
  connect(swap_, &QPushButton::clicked, this, &PartsPanel::swap_wanted);
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (const auto part = chosen()) emit remove_wanted(*part);
  });
  connect(take_apart_, &QPushButton::clicked, this, [this] {
    if (const auto part = chosen_or_only()) emit take_apart_wanted(*part);
  });
  connect(colour_, &QPushButton::clicked, this, [this] {
    if (const auto part = chosen()) emit colour_wanted(*part);
  });
  show_nothing();
}

QPushButton* PartsPanel::button(const QString& text, const char* object, const QString& doc) {
  auto* made = new QPushButton(text, this);
  made->setObjectName(QLatin1String(object));
  made->setToolTip(doc);
  return made;
}

void PartsPanel::show_nothing() {
  filling_ = true;
  rows_->clear();
  filling_ = false;
  update_buttons();
}

void PartsPanel::show_parts(const SceneBody& fixed, const std::vector<std::size_t>& counts) {
  const std::vector<SceneBody> parts = meshes_of(fixed);
  const auto count = static_cast<int>(parts.size());
  filling_ = true;
  while (rows_->topLevelItemCount() > count)
    delete rows_->takeTopLevelItem(rows_->topLevelItemCount() - 1);
  // All at once: of thousands, each by itself would be looked for among all.
  QList<QTreeWidgetItem*> added;
  rows_->model()->blockSignals(true);
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (i >= rows_->topLevelItemCount()) added.append(new QTreeWidgetItem);
    QTreeWidgetItem& row = added.isEmpty() ? *rows_->topLevelItem(i) : *added.back();
    const bool one_mesh = fixed.parts.empty();
    show_row(row, parts[at], one_mesh ? colour::fixed : part_colour(fixed, at), one_mesh);
    row.setText(part_triangles_at, at < counts.size() ? QString::number(counts[at]) : QString());
    row.setTextAlignment(part_triangles_at, Qt::AlignRight | Qt::AlignVCenter);
  }
  rows_->model()->blockSignals(false);
  rows_->addTopLevelItems(added);
  rows_->doItemsLayout();
  filling_ = false;
  update_buttons();
}

/// What is one mesh has its ticks in the dock for seeing, and is always felt.
void PartsPanel::show_row(QTreeWidgetItem& row, const SceneBody& part, const QColor& colour,
                          bool only) {
  row.setText(part_name_at, QString::fromStdString(part_name(part)));
  row.setIcon(part_name_at, patch(colour));
  const QString whole = row.text(part_name_at) + '\n' + QString::fromStdString(part.mesh.string());
  row.setToolTip(part_name_at, tooltip_of(whole));
  row.setCheckState(part_shown_at, tick(part.shown));
  row.setCheckState(part_felt_at, tick(part.felt));
  // An empty box shows on these columns, in either theme.
  for (const int column : {part_shown_at, part_felt_at})
    row.setBackground(column, QColor(128, 128, 128, 60));
  const Qt::ItemFlags seen = Qt::ItemIsSelectable | Qt::ItemIsEnabled;
  row.setFlags(only ? seen : seen | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
}

void PartsPanel::choose(std::optional<std::size_t> part) {
  filling_ = true;
  rows_->clearSelection();
  if (QTreeWidgetItem* row = part ? rows_->topLevelItem(static_cast<int>(*part)) : nullptr) {
    row->setSelected(true);
    rows_->scrollToItem(row);
  }
  filling_ = false;
  update_buttons();
}

std::optional<std::size_t> PartsPanel::chosen() const {
  const auto selected = rows_->selectedItems();
  if (selected.isEmpty()) return {};
  return static_cast<std::size_t>(rows_->indexOfTopLevelItem(selected.front()));
}

/// What is one mesh need not be chosen.
std::optional<std::size_t> PartsPanel::chosen_or_only() const {
  return rows_->topLevelItemCount() == 1 ? std::optional<std::size_t>(0) : chosen();
}

void PartsPanel::on_changed(QTreeWidgetItem* row, int column) {
  if (filling_) return;
  const auto part = static_cast<std::size_t>(rows_->indexOfTopLevelItem(row));
  if (column == part_name_at) emit rename_wanted(part, row->text(part_name_at));
  if (column == part_shown_at)
    emit shown_wanted(part, row->checkState(part_shown_at) == Qt::Checked);
  if (column == part_felt_at) emit felt_wanted(part, row->checkState(part_felt_at) == Qt::Checked);
}

void PartsPanel::update_buttons() {
  const bool any = rows_->topLevelItemCount() > 0;
  const bool several = rows_->topLevelItemCount() > 1;
  add_->setEnabled(any);
  swap_->setEnabled(any);
  colour_->setEnabled(chosen().has_value());
  remove_->setEnabled(several && chosen().has_value());
  take_apart_->setEnabled(chosen_or_only().has_value());
}

}  // namespace sonde::ui
