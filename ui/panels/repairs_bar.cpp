// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/repairs_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/elided_label.hpp"
#include "ui/base/format.hpp"
#include "ui/base/key_button.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/body_mark.hpp"

namespace sonde::ui {
namespace {

QToolButton* button(const QString& object, const QString& text, QWidget* parent) {
  auto* made = new KeyButton(parent);
  made->setObjectName(object);
  made->setText(text);
  made->setToolButtonStyle(Qt::ToolButtonTextOnly);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

void describe(QToolButton& button, const QString& name, const QString& tooltip) {
  button.setAccessibleName(name);
  button.setToolTip(tooltip);
}

}  // namespace

RepairsBar::RepairsBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("repairs_bar"));
  setAccessibleName(QStringLiteral("What was mended"));
  setFrameShape(QFrame::NoFrame);
  auto* all = new QHBoxLayout(this);
  all->setContentsMargins(8, 2, 4, 2);
  all->setSpacing(4);
  auto* lines = new QVBoxLayout;
  lines->setSpacing(2);
  rows_ = {make_row(probe), make_row(fixed)};
  for (const Widgets& row : rows_) lines->addWidget(row.row);
  all->addLayout(lines, 1);
  QToolButton* away = button(QStringLiteral("mended_away"), QStringLiteral("×"), this);
  describe(*away, QStringLiteral("Fold what was mended away"),
           QStringLiteral("Fold this bar away; What was mended, above it, brings it back"));
  away->setAutoRaise(true);
  connect(away, &QToolButton::clicked, this, &RepairsBar::put_away);
  all->addWidget(away, 0, Qt::AlignTop);
  hide();
}

RepairsBar::Widgets RepairsBar::make_row(std::size_t body) {
  const QString object =
      body == probe ? QStringLiteral("mended_probe") : QStringLiteral("mended_fixed");
  Widgets made{};
  made.row = new QWidget(this);
  auto* layout = new QHBoxLayout(made.row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  auto* mark = new BodyMark(body == probe ? colour::probe : colour::fixed, made.row);
  made.text = new ElidedLabel(made.row);
  made.text->setObjectName(object);
  made.places = new QLabel(made.row);
  made.places->setTextFormat(Qt::PlainText);
  made.places->setObjectName(object + QStringLiteral("_places"));
  made.show = button(object + QStringLiteral("_show"), QStringLiteral("Show"), made.row);
  made.repair = button(object + QStringLiteral("_repair"), {}, made.row);
  made.close = button(object + QStringLiteral("_close"), QStringLiteral("Close it"), made.row);
  layout->addWidget(mark);
  layout->addSpacing(4);
  layout->addWidget(made.text, 1);
  for (QWidget* widget : {static_cast<QWidget*>(made.places), static_cast<QWidget*>(made.show),
                          static_cast<QWidget*>(made.close), static_cast<QWidget*>(made.repair)})
    layout->addWidget(widget);
  connect(made.show, &QToolButton::clicked, this, [this, body] { emit show_wanted(body); });
  connect(made.repair, &QToolButton::clicked, this,
          [this, body] { emit repair_wanted(body, !rows_.at(body).as_in_file); });
  connect(made.close, &QToolButton::clicked, this, [this, body] { emit close_wanted(body); });
  made.row->hide();
  return made;
}

void RepairsBar::set_key(const QString& key) { key_ = key; }

void RepairsBar::show_row(std::size_t body, const std::optional<RepairsRow>& row) {
  Widgets& line = rows_.at(body);
  if (row) {
    line.as_in_file = row->as_in_file;
    line.text->show_text(QStringLiteral("%1: %2").arg(row->name, row->text));
    const QString whole = QStringLiteral("%1 %2").arg(
        body == probe ? QStringLiteral("Probe") : QStringLiteral("Fixed body"), line.text->text());
    line.text->setToolTip(tooltip_of(QStringLiteral("%1\n%2").arg(whole, row->in_full)));
    line.text->setAccessibleName(whole);
    line.show->setVisible(row->can_show);
    line.repair->setVisible(row->can_be_as_in_file || row->as_in_file);
    line.close->setVisible(row->can_close);
    line.repair->setText(row->as_in_file ? QStringLiteral("Mend it")
                                         : QStringLiteral("As in the file"));
    const QString& mesh = row->name;
    describe(*line.show, QStringLiteral("Show where %1 was mended").arg(mesh),
             QStringLiteral("Look at each place in turn") +
                 (key_.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(key_)));
    describe(*line.repair,
             row->as_in_file ? QStringLiteral("Mend %1").arg(mesh)
                             : QStringLiteral("Take %1 as in the file").arg(mesh),
             row->as_in_file ? QStringLiteral("Close its cracks, turned parts and small openings")
                             : QStringLiteral("Nothing of it is mended; can be undone"));
    describe(
        *line.close, QStringLiteral("Close the openings of %1").arg(mesh),
        QStringLiteral("Its inside counts from now on, with its openings closed; can be undone"));
    show_places(body, {}, {});
  }
  line.row->setVisible(row.has_value());
}

void RepairsBar::show_places(std::size_t body, const QString& places, const QString& in_full) {
  QLabel& label = *rows_.at(body).places;
  label.setText(places);
  label.setToolTip(in_full);
  label.setVisible(!places.isEmpty());
}

}  // namespace sonde::ui
