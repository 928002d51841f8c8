// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/contacts_panel.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/haptics/coupling/contact_force.hpp"
#include "engine/penetration/contact/contact_clusters.hpp"
#include "engine/queries/body_queries.hpp"

namespace sonde::ui {
namespace {

enum Column { name, part, force, share, position, normal, gap, joined };

std::uint64_t id_of(const QTreeWidgetItem& item) {
  return item.data(name, Qt::UserRole).toULongLong();
}

}  // namespace

ContactsPanel::ContactsPanel(QWidget* parent)
    : QDockWidget(QStringLiteral("Contacts"), parent),
      rows_(new QTreeWidget(this)),
      summary_(new QLabel(this)) {
  setObjectName(QStringLiteral("contacts_panel"));
  rows_->setObjectName(QStringLiteral("contact_rows"));
  rows_->setRootIsDecorated(false);
  rows_->setIndentation(0);
  rows_->setUniformRowHeights(true);
  rows_->setHeaderLabels({QStringLiteral("Contact"), QStringLiteral("Part"),
                          QStringLiteral("Force"), QStringLiteral("Share"),
                          QStringLiteral("Position"), QStringLiteral("Normal"),
                          QStringLiteral("Gap"), QStringLiteral("Joined")});
  const char* const tips[] = {
      "A cluster of contacts, the same number from tick to tick",
      "The part of the fixed body that it is on",
      "On the hand, along its normal: those of all contacts add up to F",
      "The size of its force, of the sum of all",
      "Of the point on the fixed body, in that body's mesh frame: x, y, z",
      "Out of the fixed body, of length 1: x, y, z",
      "Between the two points, at the separated pose",
      "How many places of contact it joins: near and alike, or in one plane"};
  for (int i = 0; i < rows_->columnCount(); ++i)
    rows_->headerItem()->setToolTip(i, QString::fromUtf8(tips[i]));
  rows_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  rows_->header()->setStretchLastSection(false);  // it would want more room than it has
  summary_->setObjectName(QStringLiteral("contact_summary"));
  summary_->setWordWrap(true);
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->addWidget(rows_);
  layout->addWidget(summary_);
  setWidget(content);
  connect(rows_, &QTreeWidget::itemSelectionChanged, this, &ContactsPanel::on_selection);
}

void ContactsPanel::take(const Pair& pair) {
  pair_ = pair;
  com_ = pair.probe().mass.com;
  unit_ = LengthUnit(pair.probe().mass.radius);
  rows_->setColumnHidden(part, pair.fixed().parts.empty());
}

void ContactsPanel::show_contacts(const Separation& separation, const Wrench& wrench) {
  std::vector<ContactCluster> clusters;
  if (separation.status == Status::penetrating)
    clusters.assign(separation.clusters.begin(), separation.clusters.end());
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
    return a.contact.multiplier > b.contact.multiplier;
  });
  const double newton = force_per_multiplier(wrench, separation.clusters, separation.device * com_);
  filling_ = true;
  while (rows_->topLevelItemCount() > static_cast<int>(clusters.size()))
    delete rows_->takeTopLevelItem(rows_->topLevelItemCount() - 1);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const ContactCluster& c = clusters[i];
    if (rows_->topLevelItemCount() <= static_cast<int>(i))
      rows_->addTopLevelItem(new QTreeWidgetItem);
    QTreeWidgetItem& row = *rows_->topLevelItem(static_cast<int>(i));
    row.setData(name, Qt::UserRole, QVariant::fromValue(static_cast<qulonglong>(c.id)));
    row.setText(name, QString::number(c.id));
    if (pair_ && !rows_->isColumnHidden(part))
      row.setText(part, text(std::string(part_at(pair_->fixed(), c.contact.on_fixed))));
    const double percent = 100 * share_of_force(c.contact, separation.clusters);
    row.setText(share, percent > 0 ? QStringLiteral("%1 %").arg(percent, 0, 'f', 0) : QString());
    row.setText(force, number(newton * c.contact.multiplier) + QStringLiteral(" N"));
    row.setText(position, unit_.text(c.contact.on_fixed));
    row.setText(normal, components_text(c.contact.normal));
    row.setText(gap, unit_.text(c.contact.gap));
    row.setText(joined, QString::number(c.rows));
    row.setSelected(chosen_ != 0 && c.id == chosen_);
  }
  filling_ = false;
  summary_->setText(clusters.empty()
                        ? QStringLiteral("No contact.")
                        : QStringLiteral("Click a row, or a contact in the view, to mark it."));
}

void ContactsPanel::choose(std::uint64_t id) {
  chosen_ = id;
  filling_ = true;
  for (int i = 0; i < rows_->topLevelItemCount(); ++i) {
    QTreeWidgetItem& row = *rows_->topLevelItem(i);
    row.setSelected(id != 0 && id_of(row) == id);
  }
  filling_ = false;
}

void ContactsPanel::on_selection() {
  if (filling_) return;
  const auto selected = rows_->selectedItems();
  chosen_ = selected.isEmpty() ? 0 : id_of(*selected.front());
  emit chosen_changed(chosen_);
}

}  // namespace sonde::ui
