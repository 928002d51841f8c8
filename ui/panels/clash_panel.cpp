// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/clash_panel.hpp"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/panels/number_field.hpp"
#include "ui/panels/work_row.hpp"

namespace sonde::ui {
namespace {

enum ClashColumn { clash_first, clash_second, clash_state, clash_length, clash_bound, clash_way };

double length_in(const NumberField& field, const LengthUnit& unit) {
  const double typed = field.number() * unit.metres();
  return typed > 0 && std::isfinite(typed) ? typed : 0;
}

QString optional_text(const std::optional<double>& length, const LengthUnit& unit) {
  return length ? unit.text(*length) : QString();
}

}  // namespace

QString way_out_text(const Clash& clash, const std::vector<AssemblyPart>& parts,
                     const LengthUnit& unit) {
  if (!clash.separated) return {};
  const AssemblyPart& part = parts[clash.moved];
  const Vec3& com = part.body->mass.com;
  const Vec3 moved = *clash.separated * com - part.X_WM * com;
  const double turn = Eigen::AngleAxisd(clash.separated->q * part.X_WM.q.conjugate()).angle();
  return QStringLiteral("%1 by %2, %3")
      .arg(QString::fromStdString(part.name), unit.text(moved), angle_text(turn));
}

ClashPanel::ClashPanel(QWidget* parent)
    : QDockWidget(QStringLiteral("Clash"), parent),
      rows_(new QTreeWidget(this)),
      summary_(new QLabel(this)),
      within_(new NumberField(this)),
      allowance_(new NumberField(this)),
      within_label_(new QLabel(this)),
      allowance_label_(new QLabel(this)),
      work_(new WorkRow(QStringLiteral("Find clashes"), QStringLiteral("clash_find"), this)) {
  setObjectName(QStringLiteral("clash_panel"));
  rows_->setObjectName(QStringLiteral("clash_rows"));
  rows_->setRootIsDecorated(false);
  rows_->setIndentation(0);
  rows_->setUniformRowHeights(true);
  rows_->setHeaderLabels({QStringLiteral("Part"), QStringLiteral("Part"), QStringLiteral("Are"),
                          QStringLiteral("Depth, or room"), QStringLiteral("At least"),
                          QStringLiteral("Way out")});
  rows_->headerItem()->setToolTip(
      clash_length, QStringLiteral("How deep they overlap, by the least motion that "
                                   "parts them; their distance where they are clear. "
                                   "Of parts that touch and fit, the way out of the fit"));
  rows_->headerItem()->setToolTip(clash_bound,
                                  QStringLiteral("A certified lower bound of the depth"));
  rows_->headerItem()->setToolTip(
      clash_way, QStringLiteral("The part that it moves: its centre of mass along x, y and z, and "
                                "the turn"));
  rows_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  rows_->header()->setStretchLastSection(false);
  within_->setObjectName(QStringLiteral("clash_within"));
  within_->setToolTip(QStringLiteral("Pairs that are clear by at most this are listed too"));
  allowance_->setObjectName(QStringLiteral("clash_allowance"));
  allowance_->setToolTip(QStringLiteral("Overlaps and gaps of at most this count as touching"));
  summary_->setObjectName(QStringLiteral("clash_summary"));
  summary_->setWordWrap(true);
  summary_->setTextFormat(Qt::PlainText);
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  auto* grid = new QGridLayout;
  grid->addWidget(within_label_, 0, 0);
  grid->addWidget(within_, 0, 1);
  grid->addWidget(allowance_label_, 1, 0);
  grid->addWidget(allowance_, 1, 1);
  layout->addLayout(grid);
  layout->addWidget(work_);
  layout->addWidget(summary_);
  layout->addWidget(rows_, 1);
  setWidget(content);
  connect(work_, &WorkRow::start_wanted, this, &ClashPanel::find_wanted);
  connect(work_, &WorkRow::stop_wanted, this, &ClashPanel::stop_wanted);
  connect(rows_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
    emit chosen(static_cast<std::size_t>(rows_->indexOfTopLevelItem(row)));
  });
  connect(rows_, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* row) {
    emit chosen(static_cast<std::size_t>(rows_->indexOfTopLevelItem(row)));
  });
  take(0.05);
}

void ClashPanel::take(double radius) {
  unit_ = LengthUnit(radius);
  within_label_->setText(QStringLiteral("clear by up to, %1").arg(unit_.name()));
  allowance_label_->setText(QStringLiteral("touching within, %1").arg(unit_.name()));
  within_->show_number(round_down_125(0.1 * radius) / unit_.metres());
  allowance_->show_number(0);
  rows_->clear();
  show_progress({});
  summary_->setText(
      QStringLiteral("Each two of the fixed body's parts, and each with the probe where it is."));
}

double ClashPanel::within() const { return length_in(*within_, unit_); }

double ClashPanel::allowance() const { return length_in(*allowance_, unit_); }

void ClashPanel::show_progress(std::optional<double> fraction, double elapsed) {
  work_->show_progress(fraction, elapsed);
}

void ClashPanel::show_reason(const QString& reason) { summary_->setText(reason); }

void ClashPanel::show_clashes(const std::vector<AssemblyPart>& parts,
                              const std::vector<Clash>& found) {
  rows_->clear();
  for (const Clash& clash : found) {
    auto* row = new QTreeWidgetItem;
    row->setText(clash_first, QString::fromStdString(parts[clash.parts[0]].name));
    row->setText(clash_second, QString::fromStdString(parts[clash.parts[1]].name));
    row->setText(clash_state, QLatin1String(name_of(clash.kind)));
    row->setText(clash_length, optional_text(clash.depth ? clash.depth : clash.clearance, unit_));
    row->setText(clash_bound, optional_text(clash.lower_bound, unit_));
    row->setText(clash_way, clash.kind == Clash::Kind::failed ? QString::fromUtf8(clash.reason)
                                                              : way_out_text(clash, parts, unit_));
    if (clash.kind == Clash::Kind::overlapping)
      row->setToolTip(clash_state, QString::fromUtf8(clash.reason));
    rows_->addTopLevelItem(row);
  }
  const auto count = [&](Clash::Kind kind) {
    return std::ranges::count(found, kind, &Clash::kind);
  };
  summary_->setText(QStringLiteral("%1 parts. Pairs that overlap: %2, that touch: %3, that are "
                                   "near: %4. A click on a row goes there.")
                        .arg(parts.size())
                        .arg(count(Clash::Kind::overlapping))
                        .arg(count(Clash::Kind::touching))
                        .arg(count(Clash::Kind::clear)));
}

}  // namespace sonde::ui
