// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/last_second_box.hpp"

#include <QFormLayout>
#include <QLabel>

#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/history_plot.hpp"
#include "ui/tuning/gains_text.hpp"

namespace sonde::ui {
namespace {

QString chatter_words(const Buzz& buzz) {
  const Chatter& c = buzz.chatter;
  if (!buzz.loop) return QStringLiteral("none: no force moves a mouse");
  if (!(c.force > 0)) return QStringLiteral("none");
  const QString swing = QStringLiteral("%1 N at %2 Hz").arg(number(c.force), number(c.frequency));
  return c.buzzes() ? in_colour(colour::force, swing + QStringLiteral(", buzzing")) : swing;
}

QString rendered_words(const Buzz& buzz) {
  if (buzz.waiting)
    return in_colour(colour::force,
                     QStringLiteral("%1; those set wait: unstable in this contact")
                         .arg(gains_text(buzz.rendered).replace('\n', QStringLiteral(", "))));
  if (buzz.capped) return in_colour(colour::force, QStringLiteral("as much as the device bears"));
  return QStringLiteral("as set");
}

QLabel* value(QFormLayout& form, QWidget* parent, const QString& name, const char* object,
              const QString& doc) {
  auto* label = new QLabel(name, parent);
  auto* number = new QLabel(parent);
  number->setObjectName(QLatin1String(object));
  number->setAlignment(Qt::AlignRight);
  number->setTextFormat(Qt::RichText);
  label->setToolTip(doc);
  number->setToolTip(doc);
  form.addRow(label, number);
  return number;
}

}  // namespace

LastSecondBox::LastSecondBox(QWidget* parent)
    : QGroupBox(QStringLiteral("Last second, measured"), parent) {
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 4, 0, 0);
  form->setVerticalSpacing(3);
  chatter_ = value(*form, this, QStringLiteral("chatter"), "chatter_value",
                   QStringLiteral("The force of what the loop makes swing between 20 and 500 Hz, "
                                  "and how fast it swings. It buzzes where a hand can feel it: "
                                  "from %1 m/s² of the handle on. What the hand itself does, and "
                                  "knocks that ring, are none.")
                       .arg(number(felt_acceleration)));
  energy_ = value(*form, this, QStringLiteral("energy to the hand"), "energy_value",
                  QStringLiteral("Net work of force and torque on the hand. Over a whole contact a "
                                 "passive wall gives none."));
  rendered_ =
      value(*form, this, QStringLiteral("gains"), "rendered_gains",
            QStringLiteral("Gains stiffer than the device bears by its maker's word are "
                           "taken as that. In a contact, gains that would be unstable in it, "
                           "by an estimate, wait until it is left."));
  for (QLabel* words : {chatter_, rendered_}) words->setWordWrap(true);
  chatter_plot_ = new HistoryPlot(QStringLiteral("chatter"), colour::contact, this);
  chatter_plot_->set_unit(1, QStringLiteral("N"));
  form->addRow(chatter_plot_);
  show_buzz({}, 0);
}

void LastSecondBox::clear_history() {
  chatter_plot_->clear();
  show_buzz({}, 0);
}

void LastSecondBox::show_buzz(const std::optional<Buzz>& buzz, double time) {
  if (!buzz) {
    for (QLabel* each : {chatter_, energy_, rendered_}) each->setText(QStringLiteral("–"));
    return;
  }
  chatter_->setText(chatter_words(*buzz));
  rendered_->setText(rendered_words(*buzz));
  energy_->setText(number(1e3 * buzz->energy) + QStringLiteral(" mJ"));
  chatter_plot_->add(time, buzz->chatter.force);
  chatter_plot_->update();
}

}  // namespace sonde::ui
