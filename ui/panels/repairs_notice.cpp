// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/repairs_notice.hpp"

#include <QAction>
#include <QHBoxLayout>
#include <algorithm>

#include "ui/base/elided_label.hpp"
#include "ui/base/format.hpp"
#include "ui/base/key_button.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/body_mark.hpp"

namespace sonde::ui {

RepairsNotice::RepairsNotice(QWidget* parent) : QWidget(parent), button_(new KeyButton(this)) {
  setObjectName(QStringLiteral("repairs_notice"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 0, 4, 0);
  layout->setSpacing(8);
  button_->setObjectName(QStringLiteral("mended_unfold"));
  button_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  button_->setFocusPolicy(Qt::TabFocus);
  button_->setAutoRaise(true);  // as the other tools
  button_->hide();
  layout->addWidget(button_);
  rows_ = {make_row(RepairsBar::probe), make_row(RepairsBar::fixed)};
  for (const Widgets& row : rows_) layout->addWidget(row.row);
  layout->addStretch(1);
}

RepairsNotice::Widgets RepairsNotice::make_row(std::size_t body) {
  const bool is_probe = body == RepairsBar::probe;
  Widgets made{new QWidget(this), nullptr};
  auto* layout = new QHBoxLayout(made.row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(5);
  layout->addWidget(new BodyMark(is_probe ? colour::probe : colour::fixed, made.row));
  made.text = new ElidedLabel(made.row);
  made.text->end_after_items(QStringLiteral(", "));
  made.text->setObjectName(is_probe ? QStringLiteral("mended_probe_notice")
                                    : QStringLiteral("mended_fixed_notice"));
  layout->addWidget(made.text, 1);
  made.row->hide();
  return made;
}

void RepairsNotice::set_action(QAction* action) {
  button_->setDefaultAction(action);
  button_->setAccessibleName(action->toolTip());
}

void RepairsNotice::show_row(std::size_t body, const std::optional<RepairsRow>& row) {
  const Widgets& line = rows_.at(body);
  if (row) {
    line.text->show_text(row->text);
    const QString whole =
        QStringLiteral("%1 %2: %3")
            .arg(body == RepairsBar::probe ? QStringLiteral("Probe") : QStringLiteral("Fixed body"),
                 row->name, row->text);
    line.text->setToolTip(tooltip_of(QStringLiteral("%1\n%2").arg(whole, row->in_full)));
    line.text->setAccessibleName(whole);
  }
  line.row->setVisible(row.has_value());
  button_->setVisible(
      std::ranges::any_of(rows_, [](const Widgets& each) { return !each.row->isHidden(); }));
}

}  // namespace sonde::ui
