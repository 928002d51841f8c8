// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/readout_panel.hpp"

#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include "ui/panels/bar.hpp"
#include "ui/panels/history_plot.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/theme.hpp"

namespace sonde::ui {
namespace {

const QColor rotation_colour(168, 140, 255);

QString in_colour(const QColor& colour, const QString& text) {
  return QStringLiteral("<span style='color:%1'>%2</span>").arg(colour.name(), text);
}

QString percent(double part) { return QString::number(100 * part, 'f', 0) + QStringLiteral(" %"); }

bool same(const Pose& a, const Pose& b) { return a.p == b.p && a.q.coeffs() == b.q.coeffs(); }

QFormLayout* form_in(QVBoxLayout& layout, QWidget* group) {
  auto* form = new QFormLayout(group);
  form->setContentsMargins(0, 4, 0, 0);
  form->setVerticalSpacing(3);
  form->setHorizontalSpacing(10);
  layout.addWidget(group);
  return form;
}

}  // namespace

ReadoutPanel::ReadoutPanel(QWidget* parent) : QDockWidget(QStringLiteral("Readout"), parent) {
  setObjectName(QStringLiteral("readout_panel"));
  const auto [scroll, content, layout] = scrolled(*this);
  layout->setSpacing(4);
  build_depth(*layout);
  build_wrench(*layout);
  build_loop(*layout);
  layout->addStretch();
  scroll->setMinimumWidth(content->minimumSizeHint().width() + 4);
}

QLabel* ReadoutPanel::value(QFormLayout& form, const QString& name, const char* object,
                            const QString& doc) {
  auto* label = new QLabel(name, form.parentWidget());
  auto* number = new QLabel(QStringLiteral("–"), form.parentWidget());
  number->setObjectName(QLatin1String(object));
  number->setAlignment(Qt::AlignRight);
  number->setTextFormat(Qt::RichText);
  // As wide as the widest number: the dock keeps its width while they change.
  number->setMinimumWidth(
      number->fontMetrics().horizontalAdvance(QStringLiteral("8888.888 mm (888 %)")));
  label->setToolTip(doc);
  number->setToolTip(doc);
  form.addRow(label, number);
  return number;
}

void ReadoutPanel::build_depth(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Penetration depth √σ"), this);
  auto* form = form_in(layout, group);
  depth_ = new QLabel(QStringLiteral("–"), group);
  depth_->setObjectName(QStringLiteral("depth_value"));
  depth_->setToolTip(QStringLiteral(
      "Root of PD_g: how far the probe's points move, in the mean, to leave the fixed body."));
  QFont large = depth_->font();
  large.setPointSizeF(20);
  large.setBold(true);
  depth_->setFont(large);
  form->addRow(depth_);
  split_ = new Bar(group);
  form->addRow(split_);
  translation_ =
      value(*form, in_colour(colour::ghost, QStringLiteral("by translation")), "translation_value",
            QStringLiteral("How far the centre of mass moves, and its share of σ."));
  rotation_ =
      value(*form, in_colour(rotation_colour, QStringLiteral("by rotation")), "rotation_value",
            QStringLiteral("How far the turn moves the points, and its share of σ."));
  pdt_ = value(*form, QStringLiteral("PD_t (global search)"), "pdt_value",
               QStringLiteral("The depth if the probe may not turn, and its ratio to √σ. It knows "
                              "nothing of the way the probe came, and may be the shorter way "
                              "through a thin wall, or none at all where the hand is free beyond "
                              "it. Grey while computed for the newest pose."));
  bound_ =
      value(*form, QStringLiteral("lower bound"), "bound_value",
            QStringLiteral("No motion shorter than this separates the two; and its ratio to √σ."));
  contacts_ = value(*form, QStringLiteral("contacts"), "contacts_value",
                    QStringLiteral("Places of contact that carry the separation."));
  depth_plot_ = new HistoryPlot(QStringLiteral("depth"), colour::ghost, group);
  form->addRow(depth_plot_);
}

void ReadoutPanel::build_wrench(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("On the hand"), this);
  auto* form = form_in(layout, group);
  force_ = value(*form, in_colour(colour::force, QStringLiteral("force |F|")), "force_value",
                 QStringLiteral("Against the force limit."));
  force_bar_ = new Bar(group);
  form->addRow(force_bar_);
  torque_ = value(*form, in_colour(colour::torque, QStringLiteral("torque |τ|")), "torque_value",
                  QStringLiteral("About the centre of mass, against the torque limit."));
  torque_bar_ = new Bar(group);
  form->addRow(torque_bar_);
  force_plot_ = new HistoryPlot(QStringLiteral("force"), colour::force, group);
  force_plot_->set_unit(1, QStringLiteral("N"));
  form->addRow(force_plot_);
}

void ReadoutPanel::build_loop(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Servo"), this);
  auto* form = form_in(layout, group);
  tick_ = value(*form, QStringLiteral("tick time"), "tick_value",
                QStringLiteral("What one turn of the haptic loop takes to compute."));
  rate_ = value(*form, QStringLiteral("rate"), "rate_value",
                QStringLiteral("Ticks a second, measured."));
  steps_ = value(*form, QStringLiteral("solver steps"), "steps_value",
                 QStringLiteral("Linearise, solve, advance: times in this tick."));
  late_ = value(*form, QStringLiteral("late ticks"), "late_value",
                QStringLiteral("Ticks that missed their deadline, since the start."));
}

void ReadoutPanel::take(const LengthUnit& unit, bool any_solid) {
  unit_ = unit;
  any_solid_ = any_solid;
  depth_plot_->set_unit(1 / unit.metres(), unit.name());
  depth_plot_->clear();
  force_plot_->clear();
}

void ReadoutPanel::sample(const Snapshot& snapshot) {
  depth_plot_->add(snapshot.time, snapshot.separation.depth);
  force_plot_->add(snapshot.time, snapshot.wrench.force.norm());
}

void ReadoutPanel::show_numbers(const Snapshot& snapshot,
                                const std::optional<CompanionResult>& companion) {
  show_depth(snapshot.separation);
  show_companion(snapshot.separation, companion);
  show_wrench(snapshot.wrench);
  show_loop(snapshot);
  depth_plot_->update();
  force_plot_->update();
}

void ReadoutPanel::show_depth(const Separation& separation) {
  if (separation.status == Status::failed) {
    depth_->setText(QStringLiteral("not found"));
    split_->set({});
    for (QLabel* label : {translation_, rotation_, contacts_}) label->setText(QStringLiteral("–"));
    return;
  }
  depth_->setText(separation.status == Status::separated ? QStringLiteral("free")
                                                         : unit_.text(separation.depth));
  const double sigma = separation.sigma;
  const double turned =
      sigma > 0 ? separation.rotation * separation.rotation / sigma : 0;  // share of σ
  const double moved = sigma > 0 ? separation.translation * separation.translation / sigma : 0;
  split_->set({{moved, colour::ghost}, {turned, rotation_colour}});
  const auto share = [&](double length, double part) {
    return sigma > 0 ? QStringLiteral("%1 (%2)").arg(unit_.text(length), percent(part))
                     : unit_.text(length);
  };
  translation_->setText(share(separation.translation, moved));
  rotation_->setText(share(separation.rotation, turned));
  contacts_->setText(QString::number(separation.clusters.size));
}

void ReadoutPanel::show_companion(const Separation& separation,
                                  const std::optional<CompanionResult>& companion) {
  if (!companion) {
    pdt_->setText(QStringLiteral("…"));
    bound_->setText(any_solid_ ? QStringLiteral("…") : QStringLiteral("none: two surfaces"));
    return;
  }
  const QColor shade = same(companion->device, separation.device) ? colour::text : colour::faint;
  const double depth = separation.depth;
  const auto beside = [&](double length) {
    return in_colour(shade, depth > 0 ? QStringLiteral("%1 (%2)").arg(unit_.text(length),
                                                                      percent(length / depth))
                                      : unit_.text(length));
  };
  if (way_out(separation, *companion) == WayOut::free_blocked) {
    pdt_->setText(QStringLiteral("free, way blocked"));
    bound_->setText(QStringLiteral("–"));
    return;
  }
  pdt_->setText(companion->pdt_valid ? beside(companion->pdt)
                                     : in_colour(shade, QStringLiteral("not found")));
  bound_->setText(companion->lower_bound ? beside(*companion->lower_bound)
                                         : QStringLiteral("none: two surfaces"));
}

void ReadoutPanel::show_wrench(const Wrench& wrench) {
  const double force = wrench.force.norm(), torque = wrench.torque.norm();
  const QString limit = wrench.saturated ? QStringLiteral(" at the limit") : QString();
  const auto limited = [&](double value, double most) {
    return value >= most * (1 - 1e-9) ? limit : QString();
  };
  force_->setText(number(force) + QStringLiteral(" N") + limited(force, coupling_.max_force));
  torque_->setText(number(torque) + QStringLiteral(" N·m") + limited(torque, coupling_.max_torque));
  force_bar_->set({{force / coupling_.max_force, colour::force}});
  torque_bar_->set({{torque / coupling_.max_torque, colour::torque}});
}

void ReadoutPanel::show_loop(const Snapshot& snapshot) {
  tick_->setText(number(snapshot.tick_us) + QStringLiteral(" µs"));
  rate_->setText(snapshot.paused
                     ? QStringLiteral("paused")
                     : QString::number(snapshot.rate_hz, 'f', 0) + QStringLiteral(" Hz"));
  steps_->setText(QString::number(snapshot.separation.iterations));
  late_->setText(QStringLiteral("%1 of %2").arg(snapshot.late).arg(snapshot.tick));
}

}  // namespace sonde::ui
