// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/contacts_panel.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "engine/penetration/contact/contact_clusters.hpp"

namespace sonde::ui {
namespace {

enum Column { name, share, multiplier, gap, rows };

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
  rows_->setHeaderLabels({QStringLiteral("Contact"), QStringLiteral("Share"),
                          QStringLiteral("Multiplier"), QStringLiteral("Gap"),
                          QStringLiteral("Rows")});
  const char* const tips[] = {"A cluster of contacts, the same number from tick to tick",
                              "The size of its force, of the sum of all",
                              "λ: how far this contact alone pushes the probe, in the object norm",
                              "Between the two points, at the separated pose",
                              "Contacts that it is made of"};
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
  connect(rows_, &QTreeWidget::itemSelectionChanged, this, [this] { on_selection(); });
}

void ContactsPanel::set_unit(const LengthUnit& unit) { unit_ = unit; }

void ContactsPanel::show_contacts(const Separation& separation) {
  std::vector<ContactCluster> clusters;
  if (separation.status == Status::penetrating)
    clusters.assign(separation.clusters.begin(), separation.clusters.end());
  std::stable_sort(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
    return a.contact.multiplier > b.contact.multiplier;
  });
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
    const double part = 100 * share_of_force(c.contact, separation.clusters);
    row.setText(share, part > 0 ? QStringLiteral("%1 %").arg(part, 0, 'f', 0) : QString());
    row.setText(multiplier, unit_.text(c.contact.multiplier));
    row.setText(gap, unit_.text(c.contact.gap));
    row.setText(rows, QString::number(c.rows));
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
  if (chosen_changed) chosen_changed(chosen_);
}

}  // namespace sonde::ui
